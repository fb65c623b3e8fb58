// How far the numbers of a finished fit may be off, from the residuals' reaction to them.
#pragma once

#include "core/study/fit/residuals.h"

#include <vector>

namespace reflectance {

struct Spread {
    std::vector<bool> atBound;         ///< per variable; such a variable counts as fixed
    std::vector<double> unitError;     ///< standard error of u where the residuals spread by 1; 0 at a bound
    std::vector<double> correlations;  ///< variables x variables
    std::vector<double> reaction;      ///< length of the residuals' change per unit of u
    std::vector<double> effectiveRows; ///< how many residuals carry that: (sum J^2)^2 / sum J^4
};

/// At the minimum u, by (J^T J)^-1 with J the residuals' derivatives in u. Directions in which nothing reacts get an error
/// of 1e7 times what their columns alone would have.
[[nodiscard]] Spread spreadAt(const Residuals& residuals, const std::vector<Variable>& variables,
                              const std::vector<double>& u, const std::vector<double>& flat);

} // namespace reflectance
