// Curves in the plane of incidence: closed forms, the units, and peaks that no sampling may miss.
#include "core/study/curves.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

using std::numbers::pi;

NamedSurface surfaceOf(const std::string& id, const ParameterValues& parameters)
{
    const Model& model = **findModel(id);
    return {id, 0, &model, flatValues(model.text, parameters)};
}

TEST(Curves, OfLambertAreFlatInEveryUnit)
{
    const NamedSurface lambert = surfaceOf("lambert", {{"kd", {0.8}}});
    const std::vector<double> angles = viewingAngles(0.5);
    const double cosine = std::cos(0.5);
    for (const auto& [quantity, expected] :
         {std::pair{Quantity::Factor, 0.8 * cosine}, std::pair{Quantity::Brdf, 0.8 / pi},
          std::pair{Quantity::BrdfCosine, 0.8 * cosine / pi}})
        for (const double number : inPlane(lambert, {0.5, quantity}, angles))
            EXPECT_NEAR(number, expected, 1e-15) << labelOf(quantity); // a few roundings of numbers below 1
}

TEST(Curves, MeetThePeakOfAnyHighlight)
{
    for (const double n : {1.0, 200.0, 1e7}) {
        const NamedSurface phong = surfaceOf("phong", {{"ks", {0.5}}, {"n", {n}}});
        const std::vector<double> angles = viewingAngles(0.7);
        const std::vector<double> numbers = inPlane(phong, {0.7}, angles);
        const auto peak = std::max_element(numbers.begin(), numbers.end());
        EXPECT_NEAR(*peak, 0.5, 1e-12) << n;
        EXPECT_NEAR(angles[static_cast<std::size_t>(peak - numbers.begin())], 0.7, 1e-12) << n;
        const auto met = std::count_if(numbers.begin(), numbers.end(), [](double number) { return number > 0.05; });
        EXPECT_GE(met, 24) << "n = " << n << " needs more samples to look like a curve";
    }
    const NamedSurface phong = surfaceOf("phong", {{"ks", {0.5}}, {"n", {1e7}}});
    double coarse = 0.0; // planted: whole degrees miss it
    for (int degrees = -90; degrees <= 90; ++degrees)
        coarse = std::max(coarse, inPlane(phong, {0.7}, {degrees * pi / 180.0})[0]);
    EXPECT_LT(coarse, 1e-6);
}

TEST(Curves, ShowOneChannelOrTheMean)
{
    const NamedSurface matte = surfaceOf("lambert_color", {{"K", {0.9, 0, 0, 0, 0.6, 0, 0, 0, 0.3}}});
    const auto shown = [&](Shown channel) { return inPlane(matte, {0.0, Quantity::Factor, channel}, {0.2})[0]; };
    EXPECT_NEAR(shown(Shown::Red), 0.9, 1e-15);
    EXPECT_NEAR(shown(Shown::Green), 0.6, 1e-15);
    EXPECT_NEAR(shown(Shown::Blue), 0.3, 1e-15);
    EXPECT_NEAR(shown(Shown::Mean), 0.6, 1e-15);
}

TEST(Curves, BecomeChartsWithTheirLightAndMirror)
{
    const std::vector<NamedSurface> surfaces{surfaceOf("lambert", {{"kd", {0.5}}}),
                                             surfaceOf("phong", {{"ks", {2.0}}, {"n", {30}}})};
    const Chart chart = overTheta(surfaces, {pi / 4});
    ASSERT_EQ(chart.series.size(), 2U);
    EXPECT_GT(chart.y.high, 2.0);
    EXPECT_LE(chart.y.low, 0.0);
    EXPECT_NEAR(chart.guides[0].at, -45.0, 1e-12);
    EXPECT_NEAR(chart.guides[1].at, 45.0, 1e-12);
    const PolarChart polar = aboutThePoint(surfaces, {pi / 4});
    EXPECT_NEAR(polar.largest, 2.1, 1e-9);
    const Chart log = overTheta(surfaces, {pi / 4, Quantity::Factor, Shown::Mean, AxisScale::Log});
    EXPECT_GE(log.y.low, 1e-7) << "underflow must not stretch the axis";
}

} // namespace
} // namespace reflectance
