// The third stage: from linear radiance to the code values of a picture, as a chain of parts that can be switched one by
// one. The formulas are the shared texts in shaders/sensor, which run here in double and in the window as GLSL.
#pragma once

#include "core/image/image.h"
#include "core/math/srgb.h"
#include "core/sensor/parts.h"

#include <cstdint>
#include <vector>

namespace reflectance {

struct Sensor {
    double exposure = 0.0; ///< EV: radiance is multiplied by 2^exposure; -16 .. 16
    bool exposes = true;   ///< the switch of `exposure`
    CameraExposure camera = {};
    Vignetting vignetting = {};
    Noise noise = {};
    Well well = {};
    Balance balance = {};
    Response response = {};
    Encoding encoding = {};
    Quantisation quantisation = {};
    SensorView view = {};

    friend bool operator==(const Sensor&, const Sensor&) = default;
};

/// What radiance is multiplied by before anything else: exposure and camera.
[[nodiscard]] double gainOf(const Sensor& sensor);

/// Electrons at value 1.
[[nodiscard]] double electronsAtWhite(const Sensor& sensor);

/// Whether its codes need more than 8 bits, so that a PNG gets 16.
[[nodiscard]] bool isDeep(const Sensor& sensor);

/// What the sensor could not show.
struct SensorCounts {
    std::size_t negative = 0;  ///< pixels with a channel below 0
    std::size_t clipped = 0;   ///< pixels with a channel that the well or the largest code cut off
    std::size_t nonFinite = 0; ///< pixels with a NaN or infinite channel
};

/// Code values, 3 per pixel, rows from the top: what the sensor made of it, rounded to the 8 or 16 bits of a file.
struct Developed {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;   ///< always: what a window shows
    std::vector<std::uint16_t> deep; ///< only where isDeep()
    SensorCounts counts;
};

/// Runs in double, so that a code differs from the exact one only where the number of levels times x lies within 1e-12 of a tie.
/// NaN and negative channels give code 0, +infinity gives the largest. Noise and dither depend on the place in the
/// picture and the seed, on nothing else.
[[nodiscard]] Developed develop(const Image& image, const Sensor& sensor);

/// The values of one pixel before the last rounding, 0 .. 1.
[[nodiscard]] Vec3d developedAt(const Image& image, int x, int y, const Sensor& sensor);

/// The exact sRGB curve (IEC 61966-2-1): linear 0 .. 1 to encoded 0 .. 1. decodeSrgb (core/math/srgb.h) goes back.
[[nodiscard]] double encodeSrgb(double linear);

/// floor(255 x + 1/2) of x clamped to 0 .. 1; NaN gives 0.
[[nodiscard]] std::uint8_t quantised(double encoded);

} // namespace reflectance
