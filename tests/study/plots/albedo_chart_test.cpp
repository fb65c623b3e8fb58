// Albedo over the light's angle: closed forms within the stated error.
#include "core/study/plots/albedo_chart.h"
#include "tests/study/plots/surfaces.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

Chart chartOf(const NamedSurface& surface, Shown shown = Shown::Mean)
{
    Progress progress;
    return *albedoOver({surface}, shown, progress);
}

/// The integral of kd cos over the hemisphere, over pi cos: kd at every angle. 1e-12: the rounding of some thousand sums.
TEST(AlbedoChart, OfLambertIsKdAtEveryAngle)
{
    const Chart chart = chartOf(test::surfaceOf("lambert", {{"kd", {0.65}}}));
    const Series& series = chart.series.at(0);
    ASSERT_EQ(series.x.size(), 12U);
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        EXPECT_NEAR(series.y[i], 0.65, series.spread[i] + 1e-12) << series.x[i]; // the error it states, and roundings
        EXPECT_LT(series.spread[i], 1e-6) << series.x[i];
    }
}

/// At normal incidence the lobe (n + 2) / 2 (R.V)^n is normalised: its albedo is ks.
TEST(AlbedoChart, OfNormalisedPhongIsKsForLightFromAbove)
{
    const Series series = chartOf(test::surfaceOf("phong_normalized", {{"ks", {0.4}}, {"n", {60.0}}})).series.at(0);
    EXPECT_NEAR(series.y[0], 0.4, series.spread[0] + 1e-9); // the error it states, and roundings of its sum
    EXPECT_LT(series.y.back(), 0.4) << "towards the horizon the lobe is cut";
}

/// The factor ks cos^n lacks the cosine: its integral over viewers, cos^(n+1), is 2 pi ks / (n + 2), over pi.
TEST(AlbedoChart, OfPhongFacingTheLightHasAClosedForm)
{
    const double n = 10.0;
    const Series series = chartOf(test::surfaceOf("phong", {{"ks", {0.5}}, {"n", {n}}})).series.at(0);
    EXPECT_NEAR(series.y[0], 0.5 * 2.0 / (n + 2.0),
                series.spread[0] + 1e-9); // the error it states, and roundings of its sum
}

TEST(AlbedoChart, ShowsTheChannelAskedFor)
{
    const NamedSurface coloured = test::surfaceOf("lambert_color", {{"K", {0.5, 0, 0, 0, 0.25, 0, 0, 0, 0.125}}});
    EXPECT_NEAR(chartOf(coloured, Shown::Red).series[0].y[3], 0.5, 1e-6); // its error stays below that, see above
    EXPECT_NEAR(chartOf(coloured, Shown::Blue).series[0].y[3], 0.125, 1e-6);
    EXPECT_NEAR(chartOf(coloured).series[0].y[3], 0.875 / 3, 1e-6);
}

/// The bar bounds the true error: a planted wrong kd lies outside of it.
TEST(AlbedoChart, ErrorsAreSmallEnoughToTellAFault)
{
    const Series series = chartOf(test::surfaceOf("lambert", {{"kd", {0.6501}}})).series.at(0);
    EXPECT_GT(std::fabs(series.y[0] - 0.65), series.spread[0] + 1e-6);
}

TEST(AlbedoChart, GivesNothingWhereItIsCancelled)
{
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(albedoOver({test::surfaceOf("lambert", {})}, Shown::Mean, progress));
}

} // namespace
} // namespace reflectance
