// From which angles a surface sends on more light than arrives.
#pragma once

#include "core/render/progress.h"
#include "core/render/view_samples.h"
#include "core/scene/scene.h"

#include <vector>

namespace reflectance {

class PassiveAngles {
public:
    /// Albedos at some angles up to 89 degrees, by quadrature. Cancelled, it knows of none above 1.
    PassiveAngles(const Scene& scene, const Progress& progress);

    /// Whether one of the scene's lights shines on the sample from an angle with an albedo above 1, for some channel.
    [[nodiscard]] bool exceededAt(const ViewSamples& samples, std::size_t sample) const;

private:
    std::vector<Light> lights_;
    std::vector<double> albedos_; ///< the largest channel, at each angle; empty where none exceeds 1
};

} // namespace reflectance
