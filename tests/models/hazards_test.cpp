// Hazards that need random rows or 50 digits. The whole list stands in core/study/extremes and is run by
// tests/study/extremes_test.cpp.
#include "core/math/lobe.h"
#include "tests/models/evaluated.h"
#include "tests/models/random_cases.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

constexpr Vec3d up{0, 0, 1};

class Hazard : public testing::TestWithParam<Precision> {
protected:
    [[nodiscard]] Vec3d ask(const OracleCase& c) const { return evaluated(c, GetParam()); }
    [[nodiscard]] double eps() const { return unitRoundoff(GetParam()); }
};

OracleCase phong(double n, const Vec3d& L, const Vec3d& V, double ks = 0.75)
{
    return {"phong", {{"ks", {ks}}, {"n", {n}}}, up, L, V, {1.0, 0.5, 0.25}};
}

TEST_P(Hazard, H04_TheLobeNeverExceedsOne)
{
    std::vector<Observation> rows;
    for (const OracleCase& c : randomCases("phong", 100000)) {
        // V = R as exactly as double can say it: where rounding lifts R.V above 1 most often.
        const Vec3d N = normalized(c.N);
        rows.push_back({N, mirrored(N, normalized(c.L)), {{c.L, {1, 1, 1}, 0.0}}});
    }
    const double values[] = {1.0, 1.0, 1.0, 1e7};
    for (const Vec3d& value : evaluate(**findModel("phong"), values, rows, GetParam()))
        ASSERT_LE(value.x, 1.0);
}

TEST_P(Hazard, H08_TheHighlightFallsSteadily)
{
    double before = ask(phong(1e6, up, up, 1.0)).x;
    EXPECT_EQ(before, 1.0);
    for (int i = 1; i <= 200; ++i) {
        const double offset = 5e-3 * i / 200;
        const OracleCase c = phong(1e6, up, {std::sin(offset), 0, std::cos(offset)}, 1.0);
        const double now = ask(c).x;
        const OracleAnswer truth = oracle(c, eps());
        const double slack =
            GetParam() == Precision::Double ? 0.0 : 4.0 * eps() * (truth.sensitivity.x + truth.value.x);
        EXPECT_LE(now, before + slack) << offset;
        if (GetParam() == Precision::Double) {
            EXPECT_LT(now, before) << offset;
        }
        before = now;
    }
}

OracleCase matte(const std::vector<double>& K, const Vec3d& I)
{
    return {"lambert_color", {{"K", K}}, up, {0.6, 0, 0.8}, up, I};
}

TEST_P(Hazard, H22_LargeOppositeEntriesLoseOnlyTheirOwnRounding)
{
    const Vec3d I{1.0, 0.9999999, 1.0000001};
    const Vec3d got = ask(matte({1e6, -1e6, 0.5, -1e6, 1e6, 0.25, 1.0, -1e6, 1e6}, I));
    const OracleAnswer truth = oracle(matte({1e6, -1e6, 0.5, -1e6, 1e6, 0.25, 1.0, -1e6, 1e6}, I), eps());
    // 4 eps of the sum of |K_ij I_j| for sum and products, as much again for rounding I and the cosine.
    EXPECT_LE(largestOf(got - truth.value), 8.0 * eps() * 2e6 * 0.8);
}

TEST_P(Hazard, H74_AZeroTermChangesNotOneBit)
{
    for (const OracleCase& c : randomCases("hybrid", 500)) {
        OracleCase general = c;
        general.parameters["ks"] = {0.0};
        OracleCase special = c;
        special.model = "lambert_color";
        ASSERT_EQ(ask(general), ask(special));
    }
}

INSTANTIATE_TEST_SUITE_P(Models, Hazard, testing::ValuesIn(corePrecisions),
                         [](const auto& given) { return std::string(nameOf(given.param)); });

} // namespace
} // namespace reflectance::test
