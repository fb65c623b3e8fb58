// Reflectance over wavelength to the three numbers of linear sRGB, as the CIE 1931 observer sees it in daylight D65.
#pragma once

#include "core/base/result.h"
#include "core/math/vec.h"

#include <optional>
#include <span>
#include <vector>

namespace reflectance {

/// Linear sRGB from XYZ (Y = 1 for white): IEC 61966-2-1.
[[nodiscard]] Vec3d linearFromXyz(const Vec3d& xyz);

/// One weight per wavelength (nm, ascending): the sum of weight times reflectance is the colour. Between its wavelengths
/// a spectrum is straight, beyond them it keeps its end values. A perfect white is (1,1,1). Observer and light enter in
/// steps of 10 nm from 380 to 730 nm, which holds all but 2e-5 of Y.
[[nodiscard]] std::vector<Vec3d> colourWeights(std::span<const double> wavelengths);

/// Weights that pick one wavelength (linear between its neighbours) as a grey; without one, those of the colour. The
/// sentence says which wavelengths there are, when the one chosen lies outside.
[[nodiscard]] Result<std::vector<Vec3d>> weightsFor(std::span<const double> wavelengths, std::optional<double> chosen);

} // namespace reflectance
