#include "core/render/settings.h"

namespace reflectance {

Result<RenderSettings> checkedSettings(int width, int height, int samplesPerPixel)
{
    constexpr int largest = 16384;
    if (width < 1 || height < 1 || width > largest || height > largest)
        return Error{"a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                     " pixels cannot be rendered; width and height go from 1 to " + std::to_string(largest)};
    for (int k = 1; k <= 8; ++k)
        if (k * k == samplesPerPixel)
            return RenderSettings{width, height, k};
    return Error{std::to_string(samplesPerPixel) +
                 " samples per pixel do not lie on a regular grid; choose 1, 4, 9, 16, 25, 36, 49 or 64"};
}

} // namespace reflectance
