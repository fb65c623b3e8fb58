// What a table is told to be about itself, and what a grid costs: against closed forms.
#include "core/math/angle.h"
#include "core/measured/facts.h"
#include "core/measured/resample.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

/// A grey surface as a function of directions.
template <class F> BrdfFunction grey(F f)
{
    return [f](std::span<const DirectionPair> pairs) {
        std::vector<std::optional<Mat3d>> values;
        for (const DirectionPair& pair : pairs) {
            Channels channels{};
            channels[0] = f(pair);
            values.emplace_back(matrixOf(channels, 1));
        }
        return values;
    };
}

const BrdfFunction lambert = grey([](const DirectionPair&) { return 0.7 / pi; });
/// The normalised Phong lobe: reciprocal, narrow, and its albedo at normal incidence is 0.5.
const BrdfFunction phong = grey([](const DirectionPair& p) {
    const Vec3d R{-p.L.x, -p.L.y, p.L.z};
    return 0.5 * 42.0 / (2.0 * pi) * std::pow(std::fmax(dot(R, p.V), 0.0), 40.0);
});

const GridShape everyShape[] = {polarShape(10), isotropicShape(31, 37), halfDifferenceShape(91, 46, 37)};

TEST(Resampling, ALambertianSurfaceIsItselfOnEveryGrid)
{
    for (const GridShape& shape : everyShape) {
        const Table table = sampled(shape, 1, lambert);
        ASSERT_TRUE(checkedTable(table));
        for (const double thetaI : {0.0, 0.7, 1.55}) {
            const Albedo albedo = albedoAt(table, thetaI);
            EXPECT_EQ(albedo.known, 1.0) << nameOf(shape.system) << ": the rim is no hole";
            EXPECT_NEAR(albedo.value.x, 0.7, 1e-12) << nameOf(shape.system);
        }
        const ResamplingError error = resamplingError(lambert, table);
        EXPECT_LT(error.rms, 1e-15);
        EXPECT_EQ(error.compared, 4096U);
        EXPECT_EQ(error.lost, 0U);
    }
}

/// Linear interpolation over a step h errs by h^2 n / 8 of the lobe (n: its exponent) along each angle; halving the steps
/// therefore divides the error by four.
TEST(Resampling, TheErrorFallsWithTheSquareOfTheStep)
{
    const auto errorWith = [](std::size_t thetas, std::size_t phis) {
        return resamplingError(phong, sampled(isotropicShape(thetas, phis), 1, phong)).rms;
    };
    const double coarse = errorWith(46, 91);
    const double fine = errorWith(91, 181);
    const double h = radians(2.0);
    EXPECT_LT(coarse, 3.0 * h * h * 40.0 / 8.0);
    EXPECT_NEAR(coarse / fine, 4.0, 0.5);
    EXPECT_GT(errorWith(7, 7), 0.1) << "a planted grid that is far too coarse";
}

TEST(Facts, AlbedoOfALobe)
{
    const Albedo albedo = albedoAt(sampled(halfDifferenceShape(91, 46, 37), 1, phong), 0.0);
    EXPECT_NEAR(albedo.value.x, 0.5, 2e-3); // the grid's error, as measured above: steps of 2 degrees
    EXPECT_LT(albedo.uncertainty, 1e-3);
}

TEST(Facts, ReciprocityIsMeasured)
{
    const auto with = [](double slope) {
        return grey([slope](const DirectionPair& p) { return 1.0 + slope * (p.L.z - p.V.z); });
    };
    const GridShape shape = isotropicShape(37, 7);
    // theta_i and theta_r come back from directions with an ulp of difference, and so do the weights.
    EXPECT_LT(reciprocityOf(sampled(shape, 1, with(0.0)), pi / 2.0).rms, 1e-14);
    const Measurement crooked = sampled(shape, 1, with(0.1));
    const ReciprocityMap map = reciprocityMap(crooked, pi, 9);
    ASSERT_EQ(map.theta.size(), 9U);
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t r = 0; r < 9; ++r) // 10 degrees: every fourth node of the grid
            EXPECT_NEAR(map.residual[i * 9 + r], 0.2 * (std::cos(map.theta[i]) - std::cos(map.theta[r])), 1e-12);
    EXPECT_NEAR(map.worst, 0.2 * (1.0 - std::cos(map.theta[8])), 1e-12);
    EXPECT_GT(reciprocityOf(crooked, radians(60.0)).rms, 0.01);
}

TEST(Facts, LeavingSamplesOutTellsWhichAngleIsTooCoarse)
{
    const Table straight =
        sampled(isotropicShape(7, 5), 1,
                grey([](const DirectionPair& p) { return 1.0 + std::atan2(std::hypot(p.V.x, p.V.y), p.V.z); }));
    const auto found = leaveOneOut(straight);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[1].along, "theta_r");
    // Straight along theta_r but for its ends, half a degree off, which are never left out but once neighbours.
    EXPECT_LT(found[1].rms, 3e-3);
    EXPECT_LT(found[0].rms, 1e-14);
    EXPECT_EQ(found[0].told, 5U * 7U * 5U);
    Table bent = straight;
    bent.values[(3 * 7 + 3) * 5 + 2] += 1.0;
    EXPECT_NEAR(leaveOneOut(bent)[0].worst, 1.0 / *std::max_element(bent.values.begin(), bent.values.end()), 1e-2);
}

TEST(Facts, HolesAreNoReflection)
{
    Table table = sampled(polarShape(10), 1, lambert);
    for (std::size_t i = 0; i < 10; ++i)
        for (std::size_t r = 5; r < 10; ++r)
            table.values[i * 10 + r] = std::nan("");
    const Albedo albedo = albedoAt(table, 0.3);
    // Up to 45 degrees: half a step of 10 beyond the last sample.
    EXPECT_NEAR(albedo.known, 0.5, 0.01);
    EXPECT_NEAR(albedo.value.x, 0.7 * albedo.known, 1e-12);
    EXPECT_GT(resamplingError(lambert, table).lost, 1000U);
}

} // namespace
} // namespace reflectance
