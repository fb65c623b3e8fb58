// One grid of wavelengths for every integral of a colour system.
#pragma once

#include "core/spectra/spectrum.h"

#include <span>

namespace reflectance {

/// integral of f = sum of weight[i] f(nm[i]).
struct WavelengthGrid {
    std::vector<double> nm;     ///< rising
    std::vector<double> weight; ///< nm, > 0

    [[nodiscard]] std::size_t size() const { return nm.size(); }
};

/// Three Gauss-Legendre nodes in each piece between neighbouring knots, every piece cut into `cuts` equal ones. Exact for
/// products of up to five spectra that are linear between samples; for bands the error falls with the sixth power.
[[nodiscard]] WavelengthGrid gridThrough(std::vector<double> knots, const WavelengthRange& range, int cuts);

/// The spectrum at every wavelength of the grid.
[[nodiscard]] std::vector<double> sampledOn(const WavelengthGrid& grid, const Spectrum& spectrum);

} // namespace reflectance
