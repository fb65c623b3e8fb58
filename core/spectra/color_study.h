// The whole question in one value: which filters, which primaries, which light - and what K costs there. For the window.
#pragma once

#include "core/spectra/color_price.h"

namespace reflectance {

struct ColorQuestion {
    std::string sensor = "gaussian"; ///< a name of sensorNamed; "gaussian" takes `crossing` and is balanced to E
    double crossing = 0.3;           ///< height at which neighbouring Gaussian filters cross, 0 .. 0.95
    std::string primaries = "E";     ///< a name of primariesNamed
    std::string under = "white";     ///< a light that the primaries can make, or a name of lightNamed

    friend bool operator==(const ColorQuestion&, const ColorQuestion&) = default;
};

/// The chart of 24 patches under one light, in truth and by every cheat.
struct ColorAnswer {
    SpectrumTriple sensors, primaries; ///< as they were integrated, for drawing
    ColorSystem system;
    std::vector<JudgedSurface> patches;
    JudgedLight light;
    std::vector<CheatPrice> prices;            ///< in the order of allCheats
    std::vector<Vec3d> truth;                  ///< linear Rec. 709 of each patch
    std::array<std::vector<Vec3d>, 5> byCheat; ///< the same by every cheat
};

[[nodiscard]] Result<ColorAnswer> answered(const ColorQuestion& question);

/// What a display shows of a response: linear Rec. 709, with the white taken to D65 (scaled XYZ).
[[nodiscard]] Vec3d displayed(const Mat3d& toXyz, const Vec3d& response, const Vec3d& white);

} // namespace reflectance
