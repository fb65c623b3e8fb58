// What reader and writer of ASAM OpenMATERIAL 3D's BRDF look-up tables share.
#pragma once

#include <numbers>

namespace reflectance::openmaterial {

/// The standard's rows have wavelengths, no colours. A colour goes as three: the dominant wavelengths (nm) of the sRGB
/// primaries, ascending. Any three of which one is blue (400 .. 500), one green (.. 580) and one red (.. 700) are read as
/// the colour itself.
inline constexpr double blue = 464.2, green = 549.1, red = 611.4;

/// The standard's largest angles are rounded down; they stand for a right angle and for a full turn.
struct RoundedAngle {
    double written, meant;
};
inline constexpr RoundedAngle roundedAngles[] = {{1.570796, std::numbers::pi / 2.0},
                                                 {6.283185, 2.0 * std::numbers::pi}};

} // namespace reflectance::openmaterial
