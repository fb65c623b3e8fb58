// Pictures are sampled and shaded in bands of rows, so that a huge picture needs no huge memory.
#pragma once

#include "core/render/cpu/cpu_renderer.h"

namespace reflectance {

struct RowBand {
    int first = 0; ///< row of the picture
    int rows = 0;
};

/// A share of a Progress: its parts add up to the share.
struct Stretch {
    Progress* progress = nullptr;
    double share = 1.0;

    [[nodiscard]] bool cancelled() const { return progress != nullptr && progress->cancel; }
    void advance(double part) const
    {
        if (progress != nullptr)
            progress->done.fetch_add(share * part);
    }
};

/// The samples of a band: `firstOfPixel` speaks of the band's pixels only.
[[nodiscard]] ViewSamples sampleBand(const RayScene& rays, const Camera& camera, const RenderSettings& settings,
                                     RowBand band, Stretch stretch);

/// Shades a band's samples into its rows of the picture.
void shadeBand(const ViewSamples& samples, RowBand band, const Scene& scene, const Arithmetic& arithmetic,
               Stretch stretch, Image& image);

} // namespace reflectance
