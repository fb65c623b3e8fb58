// The price of the cheat: how far a diagonal K, and even the full one, are from the spectral truth, in CIEDE2000.
#pragma once

#include "core/spectra/color_system.h"

#include <cstdint>

namespace reflectance {

/// What may stand for the spectral integral.
enum class Cheat {
    FullK,               ///< K I: exact for every light that the primaries can make
    BestDiagonal,        ///< the closest diagonal in the sensor convention, see bestDiagonalOf
    DiagonalOfM,         ///< diag(M) I, I in primary strengths: the lecture's
    DroppedOffDiagonals, ///< diag(K) I, K in the sensor convention
    ColorUnderWhite      ///< K (1,1,1) as albedo: what renderers do
};

inline constexpr Cheat allCheats[] = {Cheat::FullK, Cheat::BestDiagonal, Cheat::DiagonalOfM, Cheat::DroppedOffDiagonals,
                                      Cheat::ColorUnderWhite};

[[nodiscard]] std::string_view nameOf(Cheat cheat);
[[nodiscard]] std::string_view wordsFor(Cheat cheat);

/// A light under which the surfaces are looked at.
struct JudgedLight {
    std::string name;
    bool inSpan = true;        ///< the primaries can make it
    std::vector<double> power; ///< on the system's grid
    Vec3d seen;                ///< what the sensor sees of it on a perfect white
    Vec3d white;               ///< what counts as white: the primaries' for lights in the span, else the lamp's own
};

/// Nine lights that the primaries can make: white, warm, cool, three saturated and three pure ones.
[[nodiscard]] std::vector<JudgedLight> lightsInSpan(const ColorSystem& system);
[[nodiscard]] JudgedLight judgedLight(const ColorSystem& system, const Spectrum& light);

/// A surface, its matrices, and the diagonal that is closest to K over the lights in the span.
struct JudgedSurface {
    std::string name;
    std::vector<double> S; ///< on the system's grid
    Mat3d M, K;            ///< primary and sensor convention
    Vec3d bestDiagonal;    ///< in the sensor convention
};
[[nodiscard]] JudgedSurface judgedSurface(const ColorSystem& system, const Spectrum& reflectance);

/// The diagonal D for which D I is closest to K I over the lights in the span, least squares, in that convention's I.
[[nodiscard]] Vec3d bestDiagonalOf(const ColorSystem& system, const JudgedSurface& surface, Convention convention);

/// What the cheat puts in the place of K, in the sensor convention: it acts on what the sensor sees of the light.
[[nodiscard]] Mat3d matrixBy(Cheat cheat, const ColorSystem& system, const JudgedSurface& surface);

/// From sensor responses to XYZ: the 3x3 that fits the chart of 24 patches under the primaries' white, least squares.
[[nodiscard]] Mat3d xyzFromSensor(const ColorSystem& system);

struct ColorError {
    double deltaE = 0.0;
    double linear = 0.0; ///< largest difference of a channel, as a share of the white's largest
    bool negative = false;
};

/// Colours are compared as a display would show them: negative responses and XYZ count as 0 (and are counted).
[[nodiscard]] ColorError colorError(const Mat3d& toXyz, const Vec3d& truth, const Vec3d& cheat, const Vec3d& white);

struct CheatPrice {
    Cheat cheat = Cheat::FullK;
    double mean = 0.0, p95 = 0.0, max = 0.0; ///< CIEDE2000 over all surfaces and lights
    double maxLinear = 0.0;
    std::size_t negative = 0; ///< of the surfaces times lights
    std::size_t worstSurface = 0, worstLight = 0;
    std::vector<double> each; ///< CIEDE2000 [light * surfaces + surface]
};

/// Every cheat over all surfaces under all lights given.
[[nodiscard]] std::vector<CheatPrice> pricesOfCheats(const ColorSystem& system,
                                                     const std::vector<JudgedSurface>& surfaces,
                                                     const std::vector<JudgedLight>& lights);

} // namespace reflectance
