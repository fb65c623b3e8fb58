// IEEE half precision, as a value: what a picture of 16-bit floats would keep.
#pragma once

#include <cmath>

namespace reflectance {

inline constexpr float largestHalf = 65504.0F;
inline constexpr float smallestNormalHalf = 0x1p-14F;

/// The nearest half-precision number, ties to even; infinite from 65520 on, subnormal below 2^-14.
[[nodiscard]] inline float roundedToHalf(float value)
{
    if (!std::isfinite(value) || value == 0.0F)
        return value;
    if (std::fabs(value) >= 65520.0F)
        return std::copysign(INFINITY, value);
    const float quantum = std::fabs(value) < smallestNormalHalf ? 0x1p-24F : std::ldexp(1.0F, std::ilogb(value) - 10);
    return std::nearbyint(value / quantum) * quantum;
}

} // namespace reflectance
