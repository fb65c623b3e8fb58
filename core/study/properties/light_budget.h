// How much of the light one surface sends on: the number behind "this surface is not passive".
#pragma once

#include "core/study/properties/albedo.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace reflectance::properties {

/// The largest share of a light's power that leaves, over the light's angle and the three sensors.
struct LightBudget {
    double largest = 0.0; ///< above 1: more leaves than arrives; infinite where a value was not a number
    double angle = 0.0;   ///< of the light for which that is so, degrees from the normal
    double facing = 0.0;  ///< the largest of the three sensors at normal incidence
    double error = 0.0;   ///< how far two quadratures lie apart

    /// False where more leaves than arrives by more than the quadrature may err.
    [[nodiscard]] bool passive() const;
};

/// "returns up to 1.53 of the light (at 80 degrees)"
[[nodiscard]] std::string budgetText(const LightBudget& budget);

/// Measures surface after surface; its grids are made once.
class BudgetMeter {
public:
    /// Degrees. A factor that lacks the cosine exceeds every bound towards 90; 80 is where a surface still is seen well.
    static constexpr std::array<double, 4> angles{0.0, 30.0, 60.0, 80.0};

    BudgetMeter();
    [[nodiscard]] LightBudget budgetOf(const Model& model, std::span<const double> values);

private:
    std::vector<HemisphereSums> sums_;
};

} // namespace reflectance::properties
