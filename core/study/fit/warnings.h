// What the data of a fit cannot tell, in plain words.
#pragma once

#include "core/study/fit/fit.h"
#include "core/study/fit/spread.h"

namespace reflectance {

/// Sentences about numbers that are not determined, rest on few samples, lie at a bound or cannot be told apart. Sets
/// `determined` of the numbers.
[[nodiscard]] std::vector<std::string> warningsAbout(const Residuals& residuals, const Observations& observations,
                                                     const Model& model, const std::vector<Variable>& variables,
                                                     const std::vector<double>& u, const std::vector<double>& flat,
                                                     const Spread& spread, std::vector<FittedNumber>& numbers);

} // namespace reflectance
