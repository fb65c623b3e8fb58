// The places of a formula that are known to magnify rounding, each with by how much at one sample.
#pragma once

#include "core/render/view_samples.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace reflectance {

struct Suspect {
    double magnifies = 0.0; ///< the rounding of inputs, in the sample's value
    std::string words;
};

/// Horizon, lobe, colour matrix and rim of a light's disc, for every light that is on and as far as the scene's model has
/// them: a lobe and a disc where its text calls for one, a matrix where it has such a parameter.
/// R.V and N.L are given as float computes them.
[[nodiscard]] std::vector<Suspect> suspectsAt(const ViewSamples& samples, std::size_t sample, const Scene& scene);

} // namespace reflectance
