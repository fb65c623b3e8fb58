// How far a point of the surface is from the peak of a light's spot, as an angle.
#pragma once

#include "core/study/grab/grab.h"

#include <algorithm>
#include <cmath>

namespace reflectance {

/// Between two unit vectors, radians; through the chord, so that small angles keep their digits.
[[nodiscard]] inline double angleBetweenUnit(const Vec3d& a, const Vec3d& b)
{
    return 2.0 * std::asin(std::min(1.0, 0.5 * length(a - b)));
}

/// Between R and V, or between N and L.
[[nodiscard]] inline double spotAngle(SpotKind kind, const Vec3d& N, const Vec3d& L, const Vec3d& V)
{
    return kind == SpotKind::Mirrored ? angleBetweenUnit(2.0 * dot(N, L) * N - L, V) : angleBetweenUnit(N, L);
}

} // namespace reflectance
