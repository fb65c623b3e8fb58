// The angles over which reflectance is measured, and the way from directions to angles and back. N = (0,0,1).
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace reflectance {

/// Polar: (theta_i, theta_r), whatever the azimuths: the lecture's table. Isotropic: (theta_i, theta_r, delta_phi) with
/// delta_phi = phi_r - phi_i; the mirror direction has delta_phi = pi. HalfDifference: (theta_h, theta_d, phi_d) of
/// Rusinkiewicz 1998, where phi_d and phi_d + pi are one and the same by reciprocity. Specular: (theta_i, radial, azimuth),
/// the angle between V and the mirror direction and the turn about that, 0 towards N; files have it, renderers do not.
enum class AngleSystem { Polar, Isotropic, HalfDifference, Specular };

[[nodiscard]] constexpr std::string_view nameOf(AngleSystem system)
{
    constexpr std::string_view names[] = {"polar", "isotropic", "half-difference", "specular"};
    return names[static_cast<int>(system)];
}

/// Radians; as many as the system has, the rest 0.
using Angles = std::array<double, 3>;

/// "theta_i", "theta_r", ...
[[nodiscard]] std::span<const std::string_view> angleNames(AngleSystem system);

/// The largest value that an angle of the system can have: pi/2 for a theta, pi for phi_d and radial, 2 pi for
/// delta_phi and azimuth.
[[nodiscard]] double largestAngle(AngleSystem system, std::size_t axis);

/// Of unit vectors. Thetas lie within 0 .. pi for any L and V, delta_phi and azimuth within -pi .. pi
/// and phi_d within 0 .. pi. Azimuths
/// at a pole count as 0.
[[nodiscard]] Angles anglesOf(AngleSystem system, const Vec3d& L, const Vec3d& V);

struct DirectionPair {
    Vec3d L, V;
};

/// One pair of directions that has these angles, with L in the plane y = 0, and V in it on the other side (that of
/// the mirror direction) where azimuths do not matter. Half and
/// difference angles can ask for directions below the surface: z is then negative.
[[nodiscard]] DirectionPair directionsAt(AngleSystem system, const Angles& at);

/// The unit vector at polar angle theta and azimuth phi, radians.
[[nodiscard]] Vec3d directionAt(double theta, double phi);

} // namespace reflectance
