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

    /// Sum of the radiance along the rays of a pixel's samples that did not meet the object. Samples first .. last of
    /// `samples` are the covered ones: which they are follows from where their positions project to.
    [[nodiscard]] Vec3d sum(const ViewSamples& samples, std::size_t first, std::size_t last, std::size_t pixel) const
    {
        const int uncovered = perPixel_ - static_cast<int>(last - first);
        return uncovered == 0 || scene_.background.kind == BackgroundKind::Plain
                   ? static_cast<double>(uncovered) * scene_.background.color
                   : environmentSum(samples, first, last, pixel);
    }

private:
    [[nodiscard]] Vec3d environmentSum(const ViewSamples& samples, std::size_t first, std::size_t last,
                                       std::size_t pixel) const;

    int perPixel_;
    const Scene& scene_;
    RenderSettings settings_;
    PixelRays rays_;
};

} // namespace reflectance
