// What symmetric V-grooves of white Lambert walls reflect, by formulas and quadrature: a witness that traces no ray.
#pragma once

#include "core/measured/angles.h"

#include <optional>

namespace reflectance {

/// The factor pi f (N.L) of infinitely long grooves whose walls rise by `slope` (radians), kd = 1. Grooves lie turned by
/// `azimuth`; without one it is the mean over all.
struct GrooveTheory {
    double slope = 0.0;
    std::optional<double> azimuth = {};

    /// Light that is reflected once: Torrance and Sparrow's geometric attenuation, JOSA 57, 1967.
    [[nodiscard]] double once(const DirectionPair& directions) const;
    /// Light that went from one wall to the other before: the radiosity of two infinite strips along a common edge, whose form
    /// factor kernel is sin^2(w) s t / (2 (s^2 + t^2 - 2 s t cos w)^1.5) at distances s, t from it, w the angle between.
    [[nodiscard]] double twice(const DirectionPair& directions) const;
};

} // namespace reflectance
