// Directions that fill the sphere evenly, to integrate over it.
#pragma once

#include "core/math/vec.h"

#include <numbers>

namespace reflectance {

/// The i-th of `count` points of a Fibonacci sphere: equal areas, turned by the golden angle from one to the next.
[[nodiscard]] inline Vec3d evenDirection(int i, int count)
{
    const double y = 1.0 - 2.0 * (i + 0.5) / count;
    const double turn = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double across = std::sqrt(1.0 - y * y);
    return {across * std::cos(turn), y, across * std::sin(turn)};
}

} // namespace reflectance
