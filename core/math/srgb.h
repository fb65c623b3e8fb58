// The inverses of the curves in shaders/sensor/encode.glsl: sRGB (IEC 61966-2-1:1999) and Rec. 709 (ITU-R BT.709-6).
#pragma once

#include <cmath>

namespace reflectance {

/// Encoded 0 .. 1 to linear 0 .. 1.
[[nodiscard]] inline double decodeSrgb(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Encoded 0 .. 1 to linear 0 .. 1.
[[nodiscard]] inline double decodeRec709(double encoded)
{
    return encoded < 4.5 * 0.018 ? encoded / 4.5 : std::pow((encoded + 0.099) / 1.099, 1.0 / 0.45);
}

} // namespace reflectance
