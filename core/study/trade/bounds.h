// What can be proven about a scene's brightness without drawing it: rungs take their bounds from here.
#pragma once

#include "core/scene/scene.h"

#include <array>
#include <optional>

namespace reflectance {

/// The most of a light, as the sensor sees it, that arrives at any point of the unit sphere, which holds the object; nothing
/// where a point light may touch it.
[[nodiscard]] std::optional<Vec3d> mostArriving(const Light& light);

/// The same of all lights that are on.
[[nodiscard]] std::optional<Vec3d> mostArriving(const Scene& scene);

/// The largest magnitude, in any channel and direction, of what the scene's surface makes of light I; nothing for models
/// without a known bound. Oren-Nayar's A/B form: li (A + B s / t) <= A + B, since s <= 1 and li <= t.
[[nodiscard]] std::optional<double> largestRadiance(const Scene& scene, const Vec3d& I);

/// The same of all lights together.
[[nodiscard]] std::optional<double> largestRadiance(const Scene& scene);

/// max over i of sum over j of |M_ij| I_j: what a matrix makes of light at most.
[[nodiscard]] double largestOf(const std::array<double, 9>& M, const Vec3d& I);

} // namespace reflectance
