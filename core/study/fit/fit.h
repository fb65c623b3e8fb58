// Fits a model of the catalogue to observations: the parameters that leave the smallest sum of squared residuals, how well
// the data determine them, and what they do not determine, in words.
#pragma once

#include "core/base/result.h"
#include "core/render/progress.h"
#include "core/study/fit/residuals.h"

#include <set>
#include <string>
#include <vector>

namespace reflectance {

struct FitOptions {
    Weighting weighting = Weighting::Linear;
    bool cosine = false;        ///< compare pi f (N.L) instead of pi f
    int starts = 8;             ///< the defaults, and points spread evenly over the sliders' ranges
    bool robust = false;        ///< a second round in which outliers count with their root (Huber's loss)
    ParameterValues fixed;      ///< parameters that keep these values
    std::set<std::string> grey; ///< parameters that keep one number over the channels
};

struct FittedNumber {
    std::string name; ///< as Variable::name
    double value = 0.0;
    double standardError = 0.0; ///< from the residuals' own spread; 0 at a bound, where it means nothing
    bool atBound = false;
    bool determined = true; ///< false: see the warnings
};

struct FitResult {
    ParameterValues values; ///< of every parameter, fitted and fixed
    std::vector<FittedNumber> numbers;
    std::vector<double> correlations; ///< numbers x numbers, row by row; 0 beside the diagonal at bounds
    double rms = 0.0;            ///< of model minus seen, in pi f (with the cosine, if asked), whatever the weighting
    double relativeRms = 0.0;    ///< rms over the rms of what was seen
    double weightedRms = 0.0;    ///< of the residuals that were made small
    double aic = 0.0, bic = 0.0; ///< N ln(RSS / N) + 2 p and + p ln N, with p the fitted numbers and the spread
    std::size_t residuals = 0;
    int startsTried = 0, startsThatAgree = 0; ///< with the best cost to 1 part in 1e6
    int iterations = 0;                       ///< of the best start
    std::vector<std::string> warnings;
};

/// Refused, in a sentence: a model without anything to turn, one that shows a light's disc (a mirror has no BRDF), fewer
/// numbers than unknowns, numbers that are not finite. A stopped fit is an error as well.
[[nodiscard]] Result<FitResult> fitModel(const Model& model, const Observations& observations,
                                         const FitOptions& options = {}, Progress* progress = nullptr);

} // namespace reflectance
