// Directions that the hazards and the sweep share: the same ones in every run.
#pragma once

#include "core/math/vec.h"

#include <cstddef>

namespace reflectance {

/// The i-th of `count` unit vectors spread evenly over the sphere (Fibonacci spiral).
[[nodiscard]] Vec3d spread(std::size_t i, std::size_t count);

/// A unit vector at `angle` radians from the unit vector v; `azimuth` chooses the side.
[[nodiscard]] Vec3d tilted(const Vec3d& v, double angle, double azimuth);

/// The angle whose cosine is 1 - x, without forming 1 - x.
[[nodiscard]] double angleOfVersine(double x);

/// cos(angle)^n from the angle itself: exp(n log1p(-2 sin^2(angle/2))); 0 from a right angle on.
[[nodiscard]] double powerOfCosine(double angle, double n);

/// How much that power magnifies the rounding of directions and of n: n (tan(angle) + |log(cos(angle))|).
[[nodiscard]] double sensitivityOfPower(double angle, double n);

} // namespace reflectance
