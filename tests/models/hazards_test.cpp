// The hazards at which reflectance code breaks, case by case. The numbers are those of docs: H01 is n = 0, and so on.
#include "core/math/lobe.h"
#include "tests/models/evaluated.h"
#include "tests/models/random_cases.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

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

TEST_P(Hazard, H01_AnExponentOfZeroGivesTheWholePeak)
{
    const double sine = std::sqrt(1.0 - 0.49);
    EXPECT_EQ(ask(phong(0.0, up, {sine, 0, 0.7})), Vec3d(0.75, 0.375, 0.1875));
}

TEST_P(Hazard, H02_TheLobeEndsAtItsHorizonEvenForAnExponentOfZero)
{
    EXPECT_EQ(ask(phong(0.0, up, {1, 0, 0})), Vec3d());
    EXPECT_EQ(ask(phong(0.0, up, {std::sqrt(0.91), 0, -0.3})), Vec3d());
}

TEST_P(Hazard, H03_ANegativeBaseIsBlackAndNotNaN)
{
    EXPECT_EQ(ask(phong(10.0, up, {1, 0, -1e-8})), Vec3d());
}

TEST_P(Hazard, H04_TheExactPeakIsThePeak)
{
    const Vec3d peak{0.75, 0.375, 0.1875};
    const auto nearPeak = [&](const Vec3d& got) { return largestOf(got - peak) <= 2.0 * eps() * 0.75; };
    EXPECT_TRUE(nearPeak(ask(phong(1e7, {-3, 0, 4}, {3, 0, 4}))));
    OracleCase all = phong(1e7, {2, 3, 6}, {2, 3, 6});
    all.N = {2, 3, 6};
    EXPECT_TRUE(nearPeak(ask(all))) << ask(all).x - 0.75;
}

TEST_P(Hazard, H04_TheLobeNeverExceedsOne)
{
    std::vector<Observation> rows;
    for (const OracleCase& c : randomCases("phong", 100000)) {
        // V = R as exactly as double can say it: where rounding lifts R.V above 1 most often.
        const Vec3d N = normalized(c.N);
        rows.push_back({N, mirrored(N, normalized(c.L)), {{c.L, {1, 1, 1}, 0.0}}});
    }
    const double values[] = {1.0, 1e7};
    for (const Vec3d& value : evaluate(**findModel("phong"), values, rows, GetParam()))
        ASSERT_LE(value.x, 1.0);
}

TEST_P(Hazard, H05_FarOffThePeakIsTinyInDoubleAndZeroInFloat)
{
    const double value = ask(phong(1e7, up, {std::sin(0.01), 0, std::cos(0.01)}, 1.0)).x;
    // 7.065450e-218 is known to seven digits.
    if (GetParam() == Precision::Double) {
        EXPECT_NEAR(value / 7.065450e-218, 1.0, 1e-7);
    } else {
        EXPECT_EQ(value, 0.0);
    }
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

TEST_P(Hazard, H09_LargerExponentsNeverBrighten)
{
    const Vec3d V{std::sin(0.1), 0, std::cos(0.1)};
    double before = ask(phong(0.0, up, V, 1.0)).x;
    for (double n = 1e-3; n <= 1e7; n *= 1.01) {
        const double now = ask(phong(n, up, V, 1.0)).x;
        // log(lobe) = n log(cos 0.1): an ulp of n log(cos 0.1) and four of exp.
        ASSERT_LE(now, before * (1.0 + (8.0 + 0.02 * n) * eps())) << n;
        before = now;
    }
}

TEST_P(Hazard, H10_AVectorWithoutDirectionIsBlack)
{
    for (const Model& model : catalogue())
        for (int which = 0; which < 3; ++which) {
            Observation row{up, {1, 0, 1}, {{{-1, 0, 1}, {1, 1, 1}, 20.0}}};
            (which == 0 ? row.N : which == 1 ? row.V : row.lights[0].L) = {};
            EXPECT_EQ(evaluated(model.id(), {}, row, GetParam()), Vec3d()) << model.id() << ' ' << which;
        }
}

TEST_P(Hazard, H11_H12_LengthsDoNotMatter)
{
    for (const Model& model : catalogue()) {
        const Observation unit{up, {1, 0, 1.2}, {{{-1, 0, 1.1}, {1, 1, 1}, 20.0}}};
        Observation extreme = unit;
        extreme.N = {0, 0, 5e-324};
        extreme.V = 0x1p900 * unit.V;
        extreme.lights[0].L = 0x1p-900 * unit.lights[0].L;
        // Lengths that are powers of two leave no rounding to differ by.
        EXPECT_EQ(evaluated(model.id(), {}, extreme, GetParam()), evaluated(model.id(), {}, unit, GetParam()))
            << model.id();
    }
}

TEST_P(Hazard, H17_TheTerminatorIsSharp)
{
    for (const double sine : {1e-12, 1e-15}) {
        OracleCase c{"lambert", {{"kd", {1.0}}}, up, {1, 0, sine}, up};
        EXPECT_NEAR(ask(c).x, sine, 4.0 * eps() * sine);
        c.L.z = -sine;
        EXPECT_EQ(ask(c), Vec3d());
    }
}

TEST_P(Hazard, H18_OnTheHorizonNothingShines)
{
    for (const double n : {0.0, 1.0, 40.0, 1e7}) {
        EXPECT_EQ(ask(phong(n, {1, 0, 0}, {-1, 0, 0})), Vec3d());
        EXPECT_EQ(
            ask({"hybrid", {{"K", {1, 0, 0, 0, 1, 0, 0, 0, 1}}, {"ks", {1.0}}, {"n", {n}}}, up, {1, 0, 0}, {-1, 0, 0}}),
            Vec3d());
    }
    EXPECT_EQ(ask({"mirror", {{"reflectance", {1.0}}}, up, {1, 0, 0}, {-1, 0, 0}, {1, 1, 1}, 10.0}), Vec3d());
}

OracleCase matte(const std::vector<double>& K, const Vec3d& I)
{
    return {"lambert_color", {{"K", K}}, up, {0.6, 0, 0.8}, up, I};
}

TEST_P(Hazard, H20_OppositeEntriesCancelExactly)
{
    for (const auto& K : {std::vector<double>{1, -1, 0, 0, 1, -1, -1, 0, 1}, {-1, 0, 1, 1, -1, 0, 0, 1, -1}})
        EXPECT_EQ(ask(matte(K, {1, 1, 1})), Vec3d());
}

TEST_P(Hazard, H21_NegativeResultsStayNegative)
{
    const Vec3d got = ask(matte({0.9, -0.08, 0.01, 0.02, 0.7, 0.05, 0.0, -0.06, 0.5}, {0, 1, 0}));
    EXPECT_NEAR(got.x, -0.064, 8.0 * eps() * 0.064);
    EXPECT_NEAR(got.z, -0.048, 8.0 * eps() * 0.048);
}

TEST_P(Hazard, H22_LargeOppositeEntriesLoseOnlyTheirOwnRounding)
{
    const Vec3d I{1.0, 0.9999999, 1.0000001};
    const Vec3d got = ask(matte({1e6, -1e6, 0.5, -1e6, 1e6, 0.25, 1.0, -1e6, 1e6}, I));
    const OracleAnswer truth = oracle(matte({1e6, -1e6, 0.5, -1e6, 1e6, 0.25, 1.0, -1e6, 1e6}, I), eps());
    // 4 eps of the sum of |K_ij I_j| for sum and products, as much again for rounding I and the cosine.
    EXPECT_LE(largestOf(got - truth.value), 8.0 * eps() * 2e6 * 0.8);
}

TEST_P(Hazard, H23_APermutationMovesTheChannels)
{
    const Vec3d I{0.25, 0.5, 0.875};
    const Vec3d got = ask(matte({0, 1, 0, 0, 0, 1, 1, 0, 0}, I));
    const Vec3d expected = 0.8 * Vec3d(I.y, I.z, I.x);
    EXPECT_LE(largestOf(got - expected), 4.0 * eps());
    EXPECT_EQ(ask(matte({0, 0, 0, 0, 0, 0, 0, 0, 0}, I)), Vec3d()) << "the diagonal of a permutation shows nothing";
}

TEST_P(Hazard, H24_AnAlbedoAboveOneIsComputedAsItIs)
{
    EXPECT_EQ(ask({"lambert", {{"kd", {1.5}}}, up, up, up}), Vec3d(1.5, 1.5, 1.5));
    EXPECT_EQ(
        evaluated("lambert_color", {{"K", {1, 1, 1, 0, 2, 0, 0, 0, 3}}}, {up, up, {{up, {1, 1, 1}, 0.0}}}, GetParam()),
        Vec3d(3, 2, 3));
}

TEST_P(Hazard, H42_ManyLightsAddUpInAnyOrder)
{
    Observation row{up, up, {}};
    for (int i = 0; i < 1024; ++i) {
        const double angle = 0.001 * i;
        row.lights.push_back({{std::sin(angle), 0, std::cos(angle)}, (i == 400 ? 1e8 : 1.0) * Vec3d(1, 1, 1), 0.0});
    }
    double sum = 0.0;
    for (const ObservedLight& light : row.lights)
        sum += normalized(light.L).z * light.I.x;
    const double forwards = evaluated("lambert", {{"kd", {1.0}}}, row, GetParam()).x;
    std::reverse(row.lights.begin(), row.lights.end());
    const double backwards = evaluated("lambert", {{"kd", {1.0}}}, row, GetParam()).x;
    // Recursive summation of m terms: at most m eps of the sum of their sizes.
    EXPECT_NEAR(forwards, sum, 1024.0 * eps() * sum);
    EXPECT_NEAR(backwards, forwards, 1024.0 * eps() * sum);
    row.lights.insert(row.lights.begin() + 7, {up, {0, 0, 0}, 0.0});
    EXPECT_EQ(evaluated("lambert", {{"kd", {1.0}}}, row, GetParam()).x, backwards)
        << "a black light adds exactly nothing";
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

TEST(Hazards, H72_TheProgramKeepsNaNsAndSubnormals)
{
    volatile double zero = 0.0;
    EXPECT_TRUE(std::isnan(zero / zero));
    volatile double smallest = std::numeric_limits<double>::min();
    volatile float smallestFloat = std::numeric_limits<float>::min();
    EXPECT_GT(smallest / 4.0, 0.0);
    EXPECT_GT(smallestFloat / 4.0F, 0.0F);
}

} // namespace
} // namespace reflectance::test
