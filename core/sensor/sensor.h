// The third stage: from linear radiance to the code values of a picture. The same formulas stand in
// shaders/sensor/develop.glsl, which is compiled for both sides.
#pragma once

#include "core/image/image.h"
#include "core/math/srgb.h"

#include <cstdint>
#include <vector>

namespace reflectance {

struct Sensor {
    double exposure = 0.0; ///< EV: radiance is multiplied by 2^exposure; -16 .. 16

    friend bool operator==(const Sensor&, const Sensor&) = default;
};

/// What the sensor could not show.
struct SensorCounts {
    std::size_t negative = 0;  ///< pixels with a channel below 0
    std::size_t clipped = 0;   ///< pixels with a channel above 1 after exposure
    std::size_t nonFinite = 0; ///< pixels with a NaN or infinite channel
};

/// 8-bit sRGB code values, 3 per pixel, rows from the top.
struct Developed {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    SensorCounts counts;
};

/// Runs in double, so that a code differs from the exact one only where 255 x lies within 1e-12 of a tie.
/// NaN and negative channels give code 0, +infinity gives 255.
[[nodiscard]] Developed develop(const Image& image, const Sensor& sensor);

/// The exact sRGB curve (IEC 61966-2-1): linear 0 .. 1 to encoded 0 .. 1. decodeSrgb (core/math/srgb.h) goes back.
[[nodiscard]] double encodeSrgb(double linear);

/// floor(255 x + 1/2) of x clamped to 0 .. 1; NaN gives 0.
[[nodiscard]] std::uint8_t quantised(double encoded);

} // namespace reflectance
