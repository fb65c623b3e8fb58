// Whose numbers a light has, and so what K means.
#pragma once

#include "core/math/matrix3.h"

#include <string_view>

namespace reflectance {

enum class Convention {
    Primary, ///< lights are strengths of primaries: K = M
    Sensor   ///< lights are what the sensor sees of them on a perfect white: K = M W^-1
};

[[nodiscard]] constexpr std::string_view nameOf(Convention convention)
{
    return convention == Convention::Primary ? "primary" : "sensor";
}

/// Beyond this W counts as singular: twelve of sixteen digits would be lost.
inline constexpr double largestCondition = 1e12;

} // namespace reflectance
