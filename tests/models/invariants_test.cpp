// What every reflectance model promises, whatever its formula: loops over the catalogue, so a new model is held to
// them.
#include "core/math/lobe.h"
#include "tests/models/evaluated.h"
#include "tests/models/random_cases.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

class Invariants : public testing::TestWithParam<std::tuple<std::string, Precision>> {
protected:
    [[nodiscard]] std::vector<OracleCase> cases() const { return randomCases(std::get<0>(GetParam()), 200); }
    [[nodiscard]] Precision precision() const { return std::get<1>(GetParam()); }
    [[nodiscard]] Vec3d ask(const OracleCase& c) const { return evaluated(c, precision()); }
};

bool isFinite(const Vec3d& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TEST_P(Invariants, ValuesAreFinite)
{
    for (const OracleCase& c : cases())
        ASSERT_TRUE(isFinite(ask(c)));
}

TEST_P(Invariants, DefaultsAreNeverNegative)
{
    for (OracleCase c : cases()) {
        c.parameters.clear();
        const Vec3d value = ask(c);
        ASSERT_GE(std::min({value.x, value.y, value.z}), 0.0);
    }
}

TEST_P(Invariants, TwiceTheLightIsTwiceTheValue)
{
    for (OracleCase c : cases()) {
        const Vec3d once = ask(c);
        c.I = 2.0 * c.I;
        const Vec3d twice = ask(c);
        // Doubling is exact in binary wherever nothing is subnormal.
        const double smallest = precision() == Precision::Double ? 0x1p-1020 : 0x1p-120;
        ASSERT_LE(largestOf(twice - 2.0 * once), smallest);
    }
}

TEST_P(Invariants, LightsSuperpose)
{
    const auto all = cases();
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        OracleCase other = all[i];
        other.L = all[i + 1].L;
        other.I = all[i + 1].I;
        Observation both = all[i].observation();
        both.lights.push_back(other.observation().lights[0]);
        const Vec3d a = ask(all[i]);
        const Vec3d b = ask(other);
        const Vec3d expected = precision() == Precision::Double ? a + b : Vec3d(Vec3f(a) + Vec3f(b));
        ASSERT_EQ(evaluated(all[i].model, all[i].parameters, both, precision()), expected);
    }
}

/// How far values move when N, L and V turn together, in units of 8 (kappa + 1) eps: the values with and without the
/// turn each stand within a few of these of the truth, and turning rounds the inputs once more. Where a rounding of the
/// inputs can move the value by as much as the value, no digit is left to compare, and kappa, a slope, says nothing.
template <class Ask> double worstTurn(const std::vector<OracleCase>& cases, const Ask& ask, double eps)
{
    // Two mirrors make a rotation.
    const Vec3d first = normalized({1, 2, -3});
    const Vec3d second = normalized({-2, 0.5, 1});
    const auto turned = [&](const Vec3d& v) { return mirrored(second, mirrored(first, normalized(v))); };
    double worst = 0.0;
    std::size_t lost = 0;
    for (const OracleCase& c : cases) {
        OracleCase r = c;
        r.N = turned(c.N);
        r.L = turned(c.L);
        r.V = turned(c.V);
        const Vec3d difference = ask(r) - ask(c);
        const OracleAnswer truth = oracle(c, eps);
        const double tail = flushed(c, truth, eps < 0x1p-40);
        const auto units = [&](double d, double s, double v) {
            const double found = std::fabs(d) / (8.0 * eps * (s + std::fabs(v)) + tail + 1e-30);
            const bool hasDigits = eps * s < std::fabs(v);
            lost += found > 1.0 && !hasDigits ? 1 : 0;
            return hasDigits ? found : std::min(found, 1.0);
        };
        worst = std::max({worst, units(difference.x, truth.sensitivity.x, truth.value.x),
                          units(difference.y, truth.sensitivity.y, truth.value.y),
                          units(difference.z, truth.sensitivity.z, truth.value.z)});
    }
    EXPECT_LE(lost, cases.size() / 50) << "numbers without a digit are rare";
    return worst;
}

TEST_P(Invariants, TurningEverythingChangesNothing)
{
    EXPECT_LE(worstTurn(
                  cases(), [this](const OracleCase& c) { return ask(c); }, unitRoundoff(precision())),
              1.0);
}

/// The planted fault: a shade that looks at the world's z axis once where N was meant, by one part in a thousand.
TEST(InvariantsThemselves, CatchAModelThatKnowsWhereUpIs)
{
    const auto ask = [](const OracleCase& c) {
        return (1.0 + 1e-3 * normalized(c.N).z) * evaluated(c, Precision::Double);
    };
    EXPECT_GT(worstTurn(randomCases("lambert", 200), ask, 0x1p-53), 1e6);
}

INSTANTIATE_TEST_SUITE_P(Models, Invariants,
                         testing::Combine(testing::ValuesIn(allIds()), testing::ValuesIn(corePrecisions)),
                         [](const auto& given) {
                             return std::get<0>(given.param) + "_" + std::string(nameOf(std::get<1>(given.param)));
                         });

} // namespace
} // namespace reflectance::test
