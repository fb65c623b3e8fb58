// What a pixel's uncovered samples show.
#pragma once

#include "core/render/cpu/pixel_rays.h"
#include "core/render/view_samples.h"
#include "core/scene/scene.h"

namespace reflectance {

class BackgroundSampler {
public:
    /// The scene must outlive the sampler.
    BackgroundSampler(const Scene& scene, const RenderSettings& settings);

    /// Sum of the radiance along the rays of the pixel's samples that did not meet the object. Samples first .. last of
    /// `samples` are the covered ones: which they are follows from where their positions project to.
    [[nodiscard]] Vec3d sum(const ViewSamples& samples, std::size_t first, std::size_t last, int x, int y) const;

private:
    [[nodiscard]] std::uint64_t coveredMask(const ViewSamples& samples, std::size_t first, std::size_t last, int x, int y) const;

    const Scene& scene_;
    RenderSettings settings_;
    PixelRays rays_;
};

} // namespace reflectance
