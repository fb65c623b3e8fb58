// Lobes in space: projection by hand, order from the far to the near, the direction under a place, paper and numbers.
#include "core/chart/lobe_chart.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>

namespace reflectance {
namespace {

using std::numbers::pi;
using testing::HasSubstr;
using testing::Not;

/// A half ball of radius 1, rings and columns a sixteenth of a turn apart.
LobeChart dome()
{
    LobeChart chart{"A < B", "factor", 1.0, {}, {}, {}, {{"L", 0.5, pi}}};
    for (int k = 0; k <= 4; ++k)
        chart.theta.push_back(k * pi / 8);
    for (int k = 0; k <= 16; ++k)
        chart.phi.push_back(k * pi / 8);
    chart.lobes.push_back({"dome", 0x0072B2, std::vector<double>(chart.theta.size() * chart.phi.size(), 1.0)});
    return chart;
}

TEST(LobeChart, ProjectsAsOneLooksAtIt)
{
    const LobePoint side = projected(pi / 2, 0.0, 1.0, {0.0, 0.0});
    EXPECT_NEAR(side.x, 1.0, 1e-15) << "away from the light is to the right";
    const LobePoint normal = projected(0.0, 0.0, 1.0, {0.0, 0.0});
    EXPECT_NEAR(normal.y, 1.0, 1e-15) << "from the side the normal points up";
    const LobePoint above = projected(0.0, 0.0, 1.0, {0.0, pi / 2});
    EXPECT_NEAR(above.depth, 1.0, 1e-15) << "and from above towards the viewer";
    const LobePoint turned = projected(pi / 2, pi / 2, 1.0, {pi / 2, 0.0});
    EXPECT_NEAR(turned.x, 1.0, 1e-15) << "turned by a quarter";
    for (const double azimuth : {0.0, 1.0, 4.0})
        for (const double elevation : {-0.5, 0.3, 1.2}) {
            const LobePoint p = projected(0.7, 2.0, 0.8, {azimuth, elevation});
            EXPECT_NEAR(std::hypot(p.x, p.y, p.depth), 0.8, 1e-15) << "a turn keeps lengths";
        }
}

TEST(LobeChart, DrawsTheFarFirst)
{
    const auto facets = facetsOf(dome(), {0.4, 0.6});
    ASSERT_EQ(facets.size(), 4U * 16U);
    const auto depth = [](const LobeFacet& f) {
        return f.corners[0].depth + f.corners[1].depth + f.corners[2].depth + f.corners[3].depth;
    };
    for (std::size_t i = 1; i < facets.size(); ++i)
        EXPECT_LE(depth(facets[i - 1]), depth(facets[i]));
}

TEST(LobeChart, FindsTheNearestPatchUnderAPlace)
{
    const LobeChart chart = dome();
    const auto facets = facetsOf(chart, {0.0, 0.0});
    const LobeFacet* facet = facetAt(facets, 0.05, 0.6);
    ASSERT_NE(facet, nullptr);
    // From the side, phi = 3 pi / 2 (column 12) is towards the viewer; theta of height 0.6 is acos 0.6 = 0.93, ring 2.
    EXPECT_GE(facet->column, 11U);
    EXPECT_LE(facet->column, 12U);
    EXPECT_EQ(facet->ring, 2U);
    EXPECT_EQ(facetAt(facets, 0.9, 0.9), nullptr) << "beside it";
}

TEST(LobeChart, TakesNoNumberAndNegativeOnesForNothing)
{
    LobeChart chart = dome();
    chart.lobes[0].radius[chart.at(1, 3)] = std::numeric_limits<double>::quiet_NaN();
    chart.lobes[0].radius[chart.at(2, 5)] = -1.0;
    chart.lobes[0].radius[chart.at(3, 5)] = 1e9;
    for (const LobeFacet& facet : facetsOf(chart, {}))
        for (const LobePoint& corner : facet.corners)
            EXPECT_TRUE(std::isfinite(corner.x) && std::isfinite(corner.y) && std::isfinite(corner.depth));
    for (const LobeFacet& facet : facetsOf(chart, {}))
        for (const LobePoint& corner : facet.corners)
            EXPECT_LT(std::hypot(corner.x, corner.y, corner.depth), 1.2);
    EXPECT_THAT(svgOf(chart, {}, 400, 400), Not(HasSubstr("nan")));
}

TEST(LobeChart, OnPaperIsWellFormedAndDiffersByLook)
{
    const std::string filled = svgOf(dome(), {0.4, 0.6, true}, 400, 400);
    const std::string net = svgOf(dome(), {0.4, 0.6, false}, 400, 400);
    EXPECT_THAT(filled, HasSubstr("A &lt; B"));
    EXPECT_THAT(filled, HasSubstr("Z\" fill=\"#"));
    EXPECT_THAT(net, Not(HasSubstr("Z\" fill=\"#")));
    EXPECT_TRUE(filled.ends_with("</svg>\n"));
}

TEST(LobeChart, AsCsvHoldsEveryDirection)
{
    LobeChart chart = dome();
    chart.lobes[0].radius[chart.at(0, 1)] = 1.0 / 3.0; // planted: it must show
    const std::string csv = csvOf(chart);
    EXPECT_TRUE(csv.starts_with("series,theta,phi,radius\ndome,0,0,1\n"));
    EXPECT_THAT(csv, HasSubstr(",0.3333333333333333\n"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 5 * 17);
}

TEST(LobeChart, ShadesByTurning)
{
    EXPECT_EQ(shadedColor(0xFF8040, 1.0), 0xFF8040U);
    EXPECT_EQ(shadedColor(0xFF8040, 0.5), 0x804020U);
}

} // namespace
} // namespace reflectance
