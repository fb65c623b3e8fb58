// Whether what GL drew is within the bound of what double gives for the same samples, on this very driver.
#pragma once

#include "core/image/image.h"
#include "core/render/progress.h"
#include "core/render/view_samples.h"
#include "core/scene/scene.h"

#include <optional>

namespace reflectance {

/// One pixel, as GL drew it and as double has it.
struct GlPixel {
    int x = -1, y = -1;
    Vec3d drawn, exact;
    double difference = 0.0; ///< of the channel that is nearest to its bound, or furthest beyond
    double bound = 0.0;      ///< of that channel
    double ratio = 0.0;      ///< difference over bound; infinite where one is no number
};

struct GlCheck {
    GlPixel worst; ///< the largest ratio
    double largestDifference = 0.0;
    std::size_t pixels = 0; ///< that were looked at
    std::size_t beyond = 0; ///< of them: above their bound

    [[nodiscard]] bool holds() const { return beyond == 0; }
};

/// Looks at about `wanted` pixels on a grid, those that the object covers whole: at its edge the background shows, too.
/// `drawn` is GL's picture of `samples`. Nothing where `progress` is cancelled.
///
/// The bound of a channel is 64 (kappa + 1) 2^-23 |exact| plus 2^-100, kappa by differences
/// (sensitivity.h), its parts averaged over the pixel's samples: GLSL leaves divisions 2.5 units and the order of sums
/// open, so it has twice of what C++ has, in units of 2^-23. Below 2^-100 a highlight's tail may have been flushed to 0.
[[nodiscard]] std::optional<GlCheck> checkGl(const ViewSamples& samples, const Image& drawn, const Scene& scene,
                                             std::size_t wanted, const Progress& progress);

} // namespace reflectance
