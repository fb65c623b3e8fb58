// The inverse of the sRGB curve (IEC 61966-2-1:1999). The curve itself stands in shaders/sensor/develop.glsl.
#pragma once

#include <cmath>

namespace reflectance {

/// Encoded 0 .. 1 to linear 0 .. 1.
[[nodiscard]] inline double decodeSrgb(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace reflectance
