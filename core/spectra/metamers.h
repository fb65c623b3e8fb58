// Metamers: surfaces that differ, and that no K can tell apart.
#pragma once

#include "core/spectra/color_price.h"

namespace reflectance {

/// Another reflectance with the same M, and so the same K in either convention: alike in every light that the primaries can make.
/// A wave over wavelength is freed from what the nine integrals of M see (Gram and Schmidt; a metameric black, Wyszecki 1953) and
/// added as strongly as 0 .. 1 allows. On the system's grid; S itself where it leaves no room.
[[nodiscard]] std::vector<double> metamericTwin(const ColorSystem& system, const std::vector<double>& S);

/// A surface and its twin under the primaries' white and under another light.
struct MetamericPair {
    std::vector<double> twin;            ///< on the system's grid
    Vec3d ownUnderWhite, twinUnderWhite; ///< linear Rec. 709, as a display shows them
    Vec3d ownUnderLight, twinUnderLight;
    double apartUnderWhite = 0.0, apartUnderLight = 0.0; ///< CIEDE2000
};

[[nodiscard]] MetamericPair metamericPair(const ColorSystem& system, const Mat3d& toXyz, const JudgedSurface& surface,
                                          const JudgedLight& light);

} // namespace reflectance
