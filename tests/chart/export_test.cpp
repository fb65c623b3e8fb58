// Charts on paper: every number of the value stands in the CSV, and the SVG is well-formed whatever the text.
#include "core/chart/chart.h"

#include <gmock/gmock.h>
#include <limits>

namespace reflectance {
namespace {

using testing::HasSubstr;
using testing::Not;

Chart sample()
{
    Chart chart{"A < B & C", {"x", 0.0, 2.0}, {"y", 0.0, 1.0}, {}, {{0.5, false, "limit"}}};
    chart.series.push_back({"one, two", seriesColor(0), {0.0, 1.0, 2.0}, {0.1, 1.0 / 3.0, 0.9}, {0.01, 0.02, 0.03}});
    return chart;
}

std::size_t count(const std::string& text, const std::string& what)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++found;
    return found;
}

TEST(ChartCsv, HoldsEveryPointAndReadsBackExactly)
{
    EXPECT_EQ(csvOf(sample()), "series,x,y,spread\n\"one, two\",0,0.1,0.01\n\"one, two\",1,0.3333333333333333,0.02\n"
                               "\"one, two\",2,0.9,0.03\n");
    EXPECT_EQ(csvOf(PolarChart{"", "", 1.0, {{"a", 0, {0.5}, {0.25}}}, {}, {}}), "series,angle,radius\na,0.5,0.25\n");
}

TEST(ChartSvg, EscapesTextAndClosesWhatItOpens)
{
    const std::string svg = svgOf(sample(), 600, 400);
    EXPECT_THAT(svg, HasSubstr("A &lt; B &amp; C"));
    EXPECT_THAT(svg, Not(HasSubstr("A < B")));
    EXPECT_EQ(count(svg, "<svg"), count(svg, "</svg>"));
    EXPECT_EQ(count(svg, "<text"), count(svg, "</text>"));
    EXPECT_THAT(svg, HasSubstr("limit"));
    EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0U);
}

/// From the field's lower left corner (64, 354) to its right edge 424 of 600 x 400 pixels with a legend.
TEST(ChartSvg, PutsPointsWhereTheyBelong)
{
    Chart chart = sample();
    chart.series[0] = {"line", 0, {0.0, 1.0, 2.0}, {0.0, 0.5, 1.0}};
    EXPECT_THAT(svgOf(chart, 600, 400), HasSubstr("M64 354L244 194L424 34"));
    chart.series[0].y[1] = 0.6; // planted: a wrong value must show
    EXPECT_THAT(svgOf(chart, 600, 400), Not(HasSubstr("L244 194")));
}

TEST(ChartSvg, InterruptsALineWhereThereIsNoNumber)
{
    Chart chart = sample();
    chart.series[0] = {"line", 0, {0.0, 0.5, 1.0, 1.5}, {0.0, std::numeric_limits<double>::quiet_NaN(), 0.5, 1.0}};
    const std::string svg = svgOf(chart, 600, 400);
    EXPECT_THAT(svg, HasSubstr("M64 354M244 194L"));
    EXPECT_EQ(count(svg, "nan"), 0U);
}

TEST(PolarSvg, PutsTheNormalUpAndLightToTheLeft)
{
    const PolarChart chart{"", "factor", 1.0, {{"a", 0, {0.0}, {1.0}}}, {-1.5707963267948966}, {"L"}};
    // 400 x 400: the rim's radius is min(156, 300) = 156 about (200, 206).
    const std::string svg = svgOf(chart, 400, 400);
    EXPECT_THAT(svg, HasSubstr("M200 50\""));
    EXPECT_THAT(svg, HasSubstr("x1=\"200\" y1=\"206\" x2=\"44\" y2=\"206\""));
}

TEST(ChartColors, DifferFromTheirNeighbours)
{
    for (std::size_t i = 0; i < 7; ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NE(seriesColor(i), seriesColor(j));
}

} // namespace
} // namespace reflectance
