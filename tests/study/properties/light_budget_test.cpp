// The light that a surface returns, against closed forms and against published quadratures.
#include "core/study/properties/light_budget.h"

#include <gtest/gtest.h>

namespace reflectance::properties {
namespace {

LightBudget budgetOf(const char* id, const char* assignments)
{
    const Model& model = **findModel(id);
    ParameterValues values;
    for (std::string_view rest = assignments; !rest.empty();) {
        const std::size_t end = std::min(rest.find(';'), rest.size());
        EXPECT_TRUE(setParameter(model.text, rest.substr(0, end), values)) << rest;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return BudgetMeter().budgetOf(model, flatValues(model.text, values));
}

TEST(LightBudget, OfLambertIsItsAlbedoAtEveryAngle)
{
    const LightBudget half = budgetOf("lambert", "kd=0.5");
    EXPECT_NEAR(half.largest, 0.5, 1e-9); // the integrand is smooth: the quadrature's own error is far below
    EXPECT_NEAR(half.facing, 0.5, 1e-9);
    EXPECT_TRUE(half.passive());
    EXPECT_TRUE(budgetOf("lambert", "kd=1").passive()) << "all of the light is not more than all of it";
    EXPECT_FALSE(budgetOf("lambert", "kd=1.001").passive());
}

TEST(LightBudget, OfOrenNayarGrowsTowardsTheHorizonAsPublished)
{
    // Directional albedo of the A/B form at rho = 1, sigma = 0.3: A = 1 - 0.5 / (1 + 0.33 / 0.09) = .892857 at 0, and by a
    // 400-point rule .991431 at 80 degrees, given to six digits.
    const LightBudget rough = budgetOf("oren_nayar", "rho=1;sigma=0.3");
    EXPECT_NEAR(rough.facing, 0.892857, 1e-6);
    EXPECT_NEAR(rough.largest, 0.991431, 5e-6); // the kink at azimuth 90 costs either rule a few units of 1e-6
    EXPECT_EQ(rough.angle, 80.0);
    // sigma = 0.1 returns 1.005009 at 80 degrees: a little more than arrives, and that is seen.
    EXPECT_FALSE(budgetOf("oren_nayar", "rho=1;sigma=0.1").passive());
}

TEST(LightBudget, OfOneSensorAloneCounts)
{
    EXPECT_FALSE(budgetOf("lambert_color", "K=0.1 0.2 1.2").passive());
}

TEST(LightBudget, OfNotANumberIsInfinite)
{
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    const LightBudget broken = BudgetMeter().budgetOf(**findModel("lambert"), std::span(&nothing, 1));
    EXPECT_TRUE(std::isinf(broken.largest));
    EXPECT_FALSE(broken.passive());
}

} // namespace
} // namespace reflectance::properties
