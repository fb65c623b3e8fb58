// Polar coordinates about any direction.
#pragma once

#include "core/math/vec.h"

namespace reflectance::properties {

/// Two unit vectors that stand square on each other and on the axis.
struct Basis {
    Vec3d axis, T, B;
};

/// `axis` is a unit vector; T leans as far as it can towards `towards`, or is any where that has no direction.
[[nodiscard]] inline Basis basisAbout(const Vec3d& axis, const Vec3d& towards)
{
    Vec3d T = normalized(towards - dot(towards, axis) * axis);
    if (T == Vec3d() || std::fabs(dot(T, axis)) > 1e-9) {
        const Vec3d other = std::fabs(axis.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
        T = normalized(other - dot(other, axis) * axis);
    }
    return {axis, T, cross(axis, T)};
}

/// The direction at `polar` radians from the axis and `azimuth` radians from T towards B.
[[nodiscard]] inline Vec3d directionIn(const Basis& basis, double polar, double azimuth)
{
    const double radius = std::sin(polar);
    return std::cos(polar) * basis.axis + (radius * std::cos(azimuth)) * basis.T +
           (radius * std::sin(azimuth)) * basis.B;
}

} // namespace reflectance::properties
