// Angles as the user gives them (degrees) and as formulas want them.
#pragma once

#include <cmath>
#include <numbers>

namespace reflectance {

[[nodiscard]] inline double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

[[nodiscard]] inline double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

/// (2 sin(a/2))^2 for an angle a in degrees: the squared chord between two unit vectors that are a apart.
[[nodiscard]] inline double squaredChord(double degrees)
{
    const double chord = 2.0 * std::sin(0.5 * radians(degrees));
    return chord * chord;
}

} // namespace reflectance
