#include "core/study/properties/light_budget.h"

#include "core/base/text.h"
#include "core/study/properties/ask.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance::properties {
namespace {

double largestOfShare(const Share& share)
{
    const double largest = std::max({share.value.x, share.value.y, share.value.z});
    return std::isnan(share.value.x + share.value.y + share.value.z) ? std::numeric_limits<double>::infinity()
                                                                     : largest;
}

} // namespace

bool LightBudget::passive() const
{
    return largest <= 1.0 + std::max(1e-6, 2.0 * error);
}

std::string budgetText(const LightBudget& budget)
{
    return "returns up to " + general(budget.largest, 3) + " of the light (at " + general(budget.angle, 3) +
           " degrees)";
}

BudgetMeter::BudgetMeter()
{
    for (const double angle : angles)
        sums_.emplace_back(angle);
}

LightBudget BudgetMeter::budgetOf(const Model& model, std::span<const double> values)
{
    LightBudget budget;
    budget.largest = -std::numeric_limits<double>::infinity();
    for (HemisphereSums& sums : sums_) {
        const Share share = sums.albedo(model, values);
        const double here = largestOfShare(share);
        if (sums.angle() == 0.0)
            budget.facing = here;
        if (here > budget.largest) {
            budget.largest = here;
            budget.angle = sums.angle();
            budget.error = share.error;
        }
    }
    return budget;
}

} // namespace reflectance::properties
