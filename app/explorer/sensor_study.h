// What the window says of the sensor: the pixel under the mouse, and where the picture's difference from the truth comes from.
#pragma once

#include "app/explorer/measured_prices.h"
#include "core/image/waterfall.h"
#include "core/scene/scene.h"

#include <optional>

namespace reflectance::explorer {

/// A pixel of the picture at rest.
struct PixelReading {
    int x = 0, y = 0;
    Vec3d linear; ///< before the sensor
    Vec3d code;   ///< after it, 0 .. 1
};

/// The reading; nothing outside the picture.
[[nodiscard]] std::optional<PixelReading> readingOf(const Image& linear, const Sensor& sensor, int x, int y);

/// The page of the sensor.
struct SensorStudy {
    bool running = false;
    std::optional<Waterfall> waterfall; ///< of the picture at rest
};

/// From the truth, on the samples that GL drew, to the codes. Where the scene has a second variant B, B's surface is the truth,
/// and the first step is the model's. Nothing where cancelled.
[[nodiscard]] std::optional<Waterfall> windowWaterfall(const Scene& scene, const DrawnByGl& drawn, Progress& progress);

} // namespace reflectance::explorer
