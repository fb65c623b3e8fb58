#include "core/image/dimensions.h"

namespace reflectance {

Result<void> checkDimensions(long width, long height, std::size_t bytes, long pixelsPerByte, const std::string& path)
{
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width < 1 || height < 1 || width > largestSide || height > largestSide)
        return Error{"claims to be " + size + " pixels; 1 to " + std::to_string(largestSide) + " per side are read",
                     path};
    if (width * height > mostPixels)
        return Error{"claims to be " + size + " pixels; at most " + std::to_string(mostPixels) + " are read", path};
    if (width * height / pixelsPerByte > static_cast<long>(bytes))
        return Error{"is cut short: " + std::to_string(bytes) + " bytes cannot hold " + size + " pixels", path};
    return {};
}

} // namespace reflectance
