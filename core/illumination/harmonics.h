// Surroundings as nine numbers per channel: spherical harmonics up to the second order, which hold all that a matte surface could
// tell of them but for one or two per cent (Ramamoorthi and Hanrahan, An efficient representation for irradiance environment
// maps, SIGGRAPH 2001); a mirror tells much more.
#pragma once

#include "core/illumination/environment.h"

#include <array>
#include <functional>

namespace reflectance {

/// The real harmonics, orthonormal over solid angle: order 0, then 1 (y, z, x), then 2 (xy, yz, 3z^2 - 1, xz, x^2 - y^2), of a
/// unit direction.
[[nodiscard]] std::array<double, 9> harmonicsAt(const Vec3d& direction);

using Harmonics = std::array<Vec3d, 9>; ///< a coefficient per harmonic, of three channels

/// The integral of radiance times each harmonic over all directions, on a Fibonacci sphere of 20000 points.
[[nodiscard]] Harmonics projected(const std::function<Vec3d(const Vec3d&)>& radiance);

/// The sum of the series in a direction. A series cut short swings below 0 where the surroundings are dark; no light is
/// negative, so that is 0.
[[nodiscard]] Vec3d radianceOf(const Harmonics& coefficients, const Vec3d& direction);

/// The same as surroundings: a latitude-longitude picture of 128 x 64 texels, finer than anything that is left.
[[nodiscard]] Environment environmentOf(const Harmonics& coefficients);

} // namespace reflectance
