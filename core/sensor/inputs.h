// The sensor as the uniforms of shaders/sensor/*.glsl: what C++ and GL hand to the shared text.
#pragma once

#include "core/sensor/sensor.h"

namespace reflectance {

/// Bands of the false colours, one per stop, the first for all that is darker, the last for all that is brighter.
inline constexpr std::size_t falseColorBands = 12;
inline constexpr int lowestStop = -8; ///< where the second band begins, stops from white

struct SensorInputs {
    double gain = 1.0;
    int vignettingKind = 0; ///< 0 none, 1 cos^4, 2 polynomial
    double cornerTangent = 0.0;
    Vec3d fallOff{};
    int noiseOn = 0;
    double shotVariance = 0.0; ///< of value 1
    double readVariance = 0.0;
    int seed = 0;
    int wellOn = 1;
    double wellLimit = 1.0;
    int balanceOn = 0;
    Vec3d balanceRows[3]; ///< colour matrix times white balance
    int responseKind = 0; ///< 0 linear, 1 gamma, 2 curve
    double responsePower = 1.0;
    int responseCount = 0;
    int encoding = 1;      ///< 0 linear, 1 sRGB, 2 Rec. 709
    double levels = 255.0; ///< 2^bits - 1; 0 leaves the value as it is
    int dithered = 0;
    int viewKind = 0; ///< 0 picture, 1 luminance, 2 false colours
    int marks = 0;
};

[[nodiscard]] SensorInputs inputsOf(const Sensor& sensor);

/// Whether equal radiance gives equal codes wherever it falls, so that one pixel's are those of all like it.
[[nodiscard]] bool isAlikeEverywhere(const SensorInputs& inputs);

/// The colour of a band: share 0 .. 1 of each channel, as code value.
[[nodiscard]] std::array<float, 3 * falseColorBands> falseColors();

} // namespace reflectance
