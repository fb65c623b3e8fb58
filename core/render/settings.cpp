#include "core/render/settings.h"

namespace reflectance {

Result<RenderSettings> checkedSettings(int width, int height, int samples)
{
    constexpr int largest = 16384;
    if (width < 1 || height < 1 || width > largest || height > largest)
        return Error{"a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                     " pixels cannot be rendered; width and height go from 1 to " + std::to_string(largest)};
    if (samples < 1 || samples > 8)
        return Error{std::to_string(samples) + " samples per pixel axis are not possible; choose 1 to 8"};
    return RenderSettings{width, height, samples};
}

} // namespace reflectance
