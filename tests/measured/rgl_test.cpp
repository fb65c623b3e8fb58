// RGL's parameterisation against integrals done by hand.
#include "core/measured/bilinear.h"
#include "tests/measured/made_files.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>
#include <random>

namespace reflectance::testing {
namespace {

constexpr double pi = std::numbers::pi;

/// 1 + x + 2y + 3xy at the corners.
const std::vector<float> corners{1, 2, 3, 7};

TEST(WarpedSquare, IntegratesABilinearDensityExactly)
{
    const WarpedSquare square(BilinearGrid{2, 2, corners});
    EXPECT_NEAR(square.total(), 3.25, 1e-15);
    for (const double x : {0.0, 0.3, 1.0})
        for (const double y : {0.0, 0.6, 1.0}) {
            EXPECT_NEAR(square.leftOf(x, y), x + 0.5 * x * x + 2.0 * y * x + 1.5 * x * x * y, 1e-15);
            EXPECT_NEAR(square.across(y), 1.5 + 3.5 * y, 1e-15);
            EXPECT_NEAR(square.below(y), 1.5 * y + 1.75 * y * y, 1e-15);
        }
}

/// On a finer grid of random numbers: the slopes of the integrals are what is integrated.
TEST(WarpedSquare, IsTheIntegralOfItsDensity)
{
    std::mt19937_64 random(2);
    BilinearGrid grid{5, 7, {}};
    for (int i = 0; i < 35; ++i)
        grid.nodes.push_back(static_cast<float>(random() % 100) / 10.0F);
    const WarpedSquare square(grid);
    constexpr double h = 1e-6; // quadratic pieces: a central difference is exact but for rounding, 1e-16 / h
    for (double x = 0.03; x < 1.0; x += 0.1)
        for (double y = 0.05; y < 1.0; y += 0.1) {
            EXPECT_NEAR((square.leftOf(x + h, y) - square.leftOf(x - h, y)) / (2.0 * h), grid.at(x, y), 1e-8);
            EXPECT_NEAR((square.below(y + h) - square.below(y - h)) / (2.0 * h), square.across(y), 1e-8);
        }
    EXPECT_NEAR(square.leftOf(1.0, 0.4), square.across(0.4), 1e-15);
    EXPECT_EQ(square.below(1.0), square.total());
}

/// Colour planes that are x, y and 1 on the warped square show where a pair of directions lands.
const std::vector<float> places{0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1};

struct Landed {
    double x, y, scale;
};

Landed landing(const Measurement& m, const Vec3d& L, const Vec3d& V)
{
    const auto f = brdfAt(m, L, V);
    const double scale = f->rows[2].z;
    return {f->rows[0].x / scale, f->rows[1].y / scale, scale};
}

TEST(Rgl, LandsWhereTheDistributionSays)
{
    const Measurement m = measured(tensorFile(rglFields({{0.0F, corners, places}, {1.5707964F, corners, places}})));
    const Vec3d L = directionAt(0.5, 0.3);
    const Vec3d V = directionAt(0.9, 1.7);
    const Vec3d H = normalized(L + V);
    const double x = std::sqrt(2.0 * std::acos(H.z) / pi);
    const double y = (std::atan2(H.y, H.x) - 0.3 + pi) / (2.0 * pi);
    const Landed at = landing(m, L, V);
    // The polar angle's arc cosine here costs three digits.
    EXPECT_NEAR(at.x, (x + 0.5 * x * x + 2.0 * y * x + 1.5 * x * x * y) / (1.5 + 3.5 * y), 1e-13);
    EXPECT_NEAR(at.y, (1.5 * y + 1.75 * y * y) / 3.25, 1e-13);
    EXPECT_NEAR(at.scale, 2.0 / (4.0 * 1.0) / V.z, 1e-15) << "ndf / (4 sigma), and the cosine divided out";
}

/// Halfway between two angles of incidence: the densities are mixed, each as a share of its own total.
TEST(Rgl, MixesSlicesByTheirShares)
{
    const std::vector<float> even{10, 10, 10, 10};
    const Measurement m = measured(tensorFile(rglFields({{0.0F, corners, places}, {1.0F, even, places}})));
    const Vec3d L = directionAt(0.25, 0.0);
    const Vec3d V = directionAt(0.8, 2.0);
    const Vec3d H = normalized(L + V);
    const double y = (std::atan2(H.y, H.x) + pi) / (2.0 * pi);
    EXPECT_NEAR(landing(m, L, V).y, 0.75 * (1.5 * y + 1.75 * y * y) / 3.25 + 0.25 * y, 1e-13);
    EXPECT_FALSE(brdfAt(m, directionAt(1.1, 0.0), V)) << "no slice beyond: nothing is extrapolated";
}

TEST(Rgl, TurnsWithTheSurfaceAndKeepsFromNegativeColours)
{
    std::vector<float> negative = places;
    negative[8] = negative[9] = negative[10] = negative[11] = -1.0F;
    const Measurement m = measured(tensorFile(rglFields({{0.0F, corners, negative}, {1.5707964F, corners, negative}})));
    EXPECT_EQ(provenanceOf(m).negatives, 8U);
    const auto one = brdfAt(m, directionAt(0.5, 0.3), directionAt(0.9, 1.7));
    const auto turned = brdfAt(m, directionAt(0.5, 3.3), directionAt(0.9, 4.7));
    EXPECT_NEAR(one->rows[0].x, turned->rows[0].x, 1e-13);
    EXPECT_EQ(one->rows[2].z, 0.0);
}

TEST(Rgl, RefusesWhatItCannotShow)
{
    const auto good = rglFields({{0.0F, corners, places}, {1.0F, corners, places}});
    const auto changed = [&](auto change) {
        auto fields = good;
        change(fields);
        return refusal(tensorFile(fields));
    };
    using ::testing::HasSubstr;
    EXPECT_EQ(changed([](auto&) {}), "");
    EXPECT_THAT(changed([](auto& f) { f[0] = {"phi_i", {8}, {0, 1, 2, 3, 4, 5, 6, 7}}; }), HasSubstr("anisotropic"));
    EXPECT_THAT(changed([](auto& f) { f[1].values = {1.0F, 0.0F}; }), HasSubstr("do not ascend"));
    EXPECT_THAT(changed([](auto& f) { f[4].values[0] = -1.0F; }), HasSubstr("negative"));
    EXPECT_THAT(changed([](auto& f) { f[5].values[0] = std::nanf(""); }), HasSubstr("not finite"));
    EXPECT_THAT(changed([](auto& f) { f.pop_back(); }), HasSubstr("no field \"rgb\""));
    EXPECT_THAT(changed([](auto& f) { f[4].shape = {1, 2, 4, 1}; }), HasSubstr("smaller than 2 x 2"));
    EXPECT_THAT(changed([](auto& f) { f[4].values.assign(8, 0.0F); }), HasSubstr("0 everywhere"));
}

} // namespace
} // namespace reflectance::testing
