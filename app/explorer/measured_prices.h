// Measures what float, SIMD and GL cost and how far they are from double, on the very samples that the window shows.
// On another thread, and given up at once when the hand moves.
#pragma once

#include "core/image/image.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/sensor/sensor.h"
#include "core/study/price_tag.h"

#include <optional>
#include <vector>

namespace reflectance::explorer {

/// What GL drew, and from which samples.
struct DrawnByGl {
    ViewSamples samples;
    Image linear;
    double milliseconds = 0.0; ///< of one re-shading
};

struct Prices {
    std::vector<PriceTag> tags;
    SensorCounts counts; ///< of GL's picture
};

/// The measurement itself; nothing where `progress` was cancelled.
[[nodiscard]] std::optional<Prices> measuredPrices(const Scene& scene, const DrawnByGl& drawn, Progress& progress);

} // namespace reflectance::explorer
