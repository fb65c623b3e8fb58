// Where K comes from: reflectance S, light primaries P_j and sensor filters s_i, integrated over wavelength.
//
//     M_ij(S) = integral of S P_j s_i        W_ij = M_ij(1), a perfect white
//
// Two conventions, each exact for every light that the primaries can make:
//   primary:  lights are primary strengths I,               picture = M I,     K = M
//   sensor:   lights are what the sensor sees on white, W I, picture = K (W I), K = M W^-1
#pragma once

#include "core/base/result.h"
#include "core/spectra/convention.h"
#include "core/spectra/wavelength_grid.h"

#include <optional>

namespace reflectance {

/// Primaries and filters on one grid, scaled so that the primaries at strength 1 show a perfect white as (1,1,1).
struct ColorSystem {
    WavelengthGrid grid;
    double lastChange = 0.0;                      ///< of any integral, relative, when the grid was last cut in two
    std::array<std::vector<double>, 3> primaries; ///< P_j on the grid, gain included
    std::array<std::vector<double>, 3> sensors;   ///< s_i times the grid's weight
    Mat3d W;                                      ///< rows sum to 1 where makesWhite
    double condition = 0.0;                       ///< of W
    Vec3d gain;                                   ///< the white's strength of each primary as it was given
    bool makesWhite = true;                       ///< false: a gain is not positive; primaries are left as given

    /// Sensor responses to a light on the grid, reflected by S on the grid (an empty S is a perfect white).
    [[nodiscard]] Vec3d response(const std::vector<double>& light, const std::vector<double>& S) const;
    [[nodiscard]] Mat3d M(const std::vector<double>& S) const;
    [[nodiscard]] Mat3d K(const std::vector<double>& S, Convention convention) const;
};

/// What else shall be integrated on the same grid.
struct AlsoOnGrid {
    std::vector<Spectrum> reflectances;
    std::vector<Spectrum> lights;
    double standsStill = 1e-12; ///< largest change of an integral, relative, when the grid is cut in two once more
};

/// Refines the grid until every integral stands still.
/// Errors: wavelengths that do not overlap, filters of zeros, primaries that the sensor cannot tell apart (W singular).
[[nodiscard]] Result<ColorSystem> makeColorSystem(const SpectrumTriple& primaries, const SpectrumTriple& sensors,
                                                  const AlsoOnGrid& also);

/// The filters scaled so that each sees this light on a perfect white as 1.
[[nodiscard]] Result<SpectrumTriple> balanced(SpectrumTriple sensors, const Spectrum& light);

} // namespace reflectance
