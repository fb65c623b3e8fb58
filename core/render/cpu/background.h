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

    /// Whether a pixel with so many covered samples shows the background's one colour only, or nothing of it.
    [[nodiscard]] bool isPlain(std::size_t covered) const
    {
        return plain_ || covered == static_cast<std::size_t>(perPixel_);
    }

    /// What so many uncovered samples show of the background's colour.
    [[nodiscard]] Vec3d plainSum(int uncovered) const
    {
        return static_cast<double>(uncovered) * scene_.background.color;
    }

    /// Sum of the environment's radiance along the rays of a pixel's samples that did not meet the object. Samples first ..
    /// last of `samples` are the covered ones: which they are follows from where their positions project to.
    [[nodiscard]] Vec3d environmentSum(const ViewSamples& samples, std::size_t first, std::size_t last,
                                       std::size_t pixel) const;

private:
    int perPixel_;
    bool plain_;
    const Scene& scene_;
    RenderSettings settings_;
    PixelRays rays_;
};

} // namespace reflectance
