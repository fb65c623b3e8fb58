// How far a formula is from what was traced, and how much of that is the tracing's own noise.
#pragma once

#include "core/study/goniometer/laboratory.h"

#include <span>

namespace reflectance {

/// The factor pi f (N.L) of many pairs of directions about N = (0,0,1) for white light, mean of the channels.
using FactorFunction = std::function<std::vector<double>(std::span<const DirectionPair>)>;

[[nodiscard]] FactorFunction factorOf(const Model& model, std::vector<double> values);

/// What a formula that is a polynomial rho a + rho^2 b in its albedo holds of light that was reflected once: rho a.
[[nodiscard]] FactorFunction onceReflected(const Model& model, const ParameterValues& values, double rho);

/// Root mean squares over all cells of f as a formula says minus f as traced, weighted with both cosines and solid angles,
/// over that of f itself. Noise: what the cells' standard errors alone would make of it.
struct FormulaGap {
    double rms = 0.0, noise = 0.0;
    double mean = 0.0;  ///< of the difference, signed, over the mean of f: what the formula has too much
    double worst = 0.0; ///< largest difference of the factor pi f (N.L) between angles up to 75 degrees
    std::size_t worstCell = 0;
};
[[nodiscard]] FormulaGap gapBetween(const LabRun& run, const FactorFunction& formula);

/// What a cell holds as one number: f for white light, mean of the channels; and its standard error.
struct GreyCell {
    double f = 0.0, error = 0.0;
};
[[nodiscard]] GreyCell greyOf(const LabRun& run, std::size_t index);

} // namespace reflectance
