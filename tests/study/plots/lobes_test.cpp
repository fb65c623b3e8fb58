// Lobes and maps hold the core's numbers: closed forms, the plane of incidence, and peaks that are met.
#include "core/study/plots/lobes.h"
#include "tests/study/plots/surfaces.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

using std::numbers::pi;

LobeChart lobeOf(const NamedSurface& surface, const CurveSettings& settings)
{
    return *lobesOf({surface}, settings, Progress());
}

TEST(Lobes, OfLambertAreHalfBalls)
{
    const LobeChart chart = lobeOf(test::surfaceOf("lambert", {{"kd", {0.8}}}), {0.5, Quantity::Brdf});
    for (const double radius : chart.lobes[0].radius)
        EXPECT_NEAR(radius, 0.8 / pi, 1e-15);
    EXPECT_NEAR(chart.largest, 1.05 * 0.8 / pi, 1e-15);
}

TEST(Lobes, MeetThePlaneOfIncidenceAndThePeak)
{
    for (const double n : {20.0, 1e6}) {
        const NamedSurface phong = test::surfaceOf("phong", {{"ks", {0.5}}, {"n", {n}}});
        const LobeChart chart = lobeOf(phong, {0.7});
        EXPECT_NEAR(*std::max_element(chart.lobes[0].radius.begin(), chart.lobes[0].radius.end()), 0.5, 1e-12) << n;
        const std::vector<double> plane = inPlane(phong, {0.7}, chart.theta);
        for (std::size_t ring = 0; ring < chart.theta.size(); ++ring)
            EXPECT_EQ(chart.lobes[0].radius[chart.at(ring, 0)], plane[ring]) << "phi = 0 is that side of the plane";
    }
}

/// Ward's highlight is thousands of times as high a degree above the horizon as elsewhere.
TEST(Lobes, AreNotScaledByWhatGrowsWithoutBound)
{
    const NamedSurface ward = test::surfaceOf("ward", {});
    const LobeChart chart = lobeOf(ward, {0.7});
    EXPECT_LT(chart.largest, 100.0);
    EXPECT_GT(*std::max_element(chart.lobes[0].radius.begin(), chart.lobes[0].radius.end()), 100.0);
    EXPECT_LT(overTheta({ward}, {0.7}).y.high, 100.0);
    EXPECT_LT(aboutThePoint({ward}, {0.7}).largest, 100.0);
    const NamedSurface phong = test::surfaceOf("phong", {{"ks", {0.5}}, {"n", {1e4}}});
    EXPECT_GT(lobeOf(phong, {1.55}).largest, 0.5) << "a peak towards the horizon is no such growth";
}

TEST(Lobes, GiveNothingWhereTheyAreCancelled)
{
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(lobesOf({test::surfaceOf("lambert", {})}, {}, progress));
    EXPECT_FALSE(modelMap(test::surfaceOf("lambert", {}), {}, 180.0, progress));
}

TEST(ModelMap, HoldsTheCosineWhereTheUnitHasIt)
{
    const NamedSurface lambert = test::surfaceOf("lambert", {{"kd", {0.8}}});
    const HeatMap factor = *modelMap(lambert, {}, 180.0, Progress());
    const HeatMap f = *modelMap(lambert, {0.7, Quantity::Brdf}, 180.0, Progress());
    for (std::size_t row = 0; row < factor.rows; ++row) {
        const double theta = (static_cast<double>(row) + 0.5) * pi / 2 / static_cast<double>(factor.rows);
        EXPECT_NEAR(factor.at(7, row), 0.8 * std::cos(theta), 1e-14);
        EXPECT_NEAR(f.at(7, row), 0.8 / pi, 1e-14);
    }
    EXPECT_NE(factor.scale.label, f.scale.label) << "the scale names its unit";
}

/// The mirror direction lies along the diagonal at 180 degrees, and nowhere at 0. Planted: the other azimuth.
TEST(ModelMap, PutsTheHighlightOnItsDiagonal)
{
    const NamedSurface phong = test::surfaceOf("phong", {{"ks", {0.5}}, {"n", {400.0}}});
    const HeatMap towards = *modelMap(phong, {}, 180.0, Progress());
    const HeatMap back = *modelMap(phong, {}, 0.0, Progress());
    for (std::size_t i = 0; i < towards.rows; ++i)
        EXPECT_NEAR(towards.at(i, i), 0.5, 1e-12);
    EXPECT_LT(back.at(45, 45), 1e-6);
}

} // namespace
} // namespace reflectance
