// Measured tables that a model and a seed make: the truth behind the data is known.
#pragma once

#include "core/reflectance/catalogue.h"
#include "core/study/fit/observations.h"

#include <cstdint>
#include <functional>

namespace reflectance {

struct SyntheticTable {
    std::string model;
    ParameterValues values;
    double noise = 0.0; ///< standard deviation of what is added to pi f
    std::uint64_t seed = 1;
    std::size_t channels = 1;
    /// Samples for which this is false are holes.
    std::function<bool(const Vec3d& L, const Vec3d& V)> isSeen;
};

/// theta_i and theta_r in steps of 10 degrees up to 70, delta_phi in steps of 30 up to 180: 7 x 8 x 7 samples.
[[nodiscard]] Table synthetic(const SyntheticTable& wanted);

/// Angle between V and the mirror direction of L, degrees.
[[nodiscard]] double degreesOffMirror(const Vec3d& L, const Vec3d& V);

} // namespace reflectance
