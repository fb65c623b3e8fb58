// How much a sample's value magnifies the rounding of what it is computed from.
#pragma once

#include "core/render/view_samples.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace reflectance {

/// What moves a sample's value.
enum class Input { Normal, Viewer, Light, Parameter };

/// For each sample and channel: how far the value moves when an input moves by one unit of roundoff, over that unit;
/// the changes of all numbers of all inputs summed without sign. Over |value| it is the condition number kappa.
struct Sensitivity {
    std::vector<Vec3d> value; ///< in double
    std::vector<Vec3d> of[4]; ///< by Input
    [[nodiscard]] Vec3d all(std::size_t sample) const;
};

/// By differences: each component of N, V and L moves by 16 units of 2^-24 of the vector's length, each parameter, each
/// intensity and a light's radius by as much of itself, both ways; the larger change counts. So far roundings can
/// together carry a sample across the horizon or a light's rim, where values jump.
[[nodiscard]] Sensitivity sensitivityOf(const ViewSamples& samples, const Scene& scene);

} // namespace reflectance
