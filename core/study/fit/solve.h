// From one start to the nearest minimum: Levenberg and Marquardt's method within bounds, by Ceres.
#pragma once

#include "core/render/progress.h"
#include "core/study/fit/residuals.h"

namespace reflectance {

struct Solution {
    std::vector<double> u;
    double cost = 0.0; ///< half the sum of squared residuals; infinite where a residual is not finite
    int iterations = 0;
    bool converged = false;
};

/// `start` lies within the bounds; `flat` gives the values that are no variables. Deterministic. `progress` may stop it.
[[nodiscard]] Solution solved(const Residuals& residuals, const std::vector<Variable>& variables,
                              const std::vector<double>& start, const std::vector<double>& flat, Progress* progress);

} // namespace reflectance
