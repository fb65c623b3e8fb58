// Maps of numbers: colours keep their order, cells stand where they belong, holes are seen.
#include "core/chart/color_map.h"
#include "core/chart/heat_map.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace reflectance {
namespace {

using testing::HasSubstr;
using testing::Not;

double brightness(ChartColor color)
{
    return 0.2126 * ((color >> 16) & 0xFF) + 0.7152 * ((color >> 8) & 0xFF) + 0.0722 * (color & 0xFF);
}

HeatMap sample()
{
    HeatMap map{"map", {"x", 0.0, 3.0}, {"y", 0.0, 2.0}, 3, 2, {0.0, 0.5, 1.0, 0.0, 0.0, 0.25}, {"value", 0.0, 1.0}};
    return map;
}

TEST(ColorMap, GrowsBrighterAllTheWay)
{
    for (int k = 1; k <= 100; ++k)
        EXPECT_GT(brightness(sequentialColor(0.01 * k)), brightness(sequentialColor(0.01 * (k - 1)))) << k;
    EXPECT_EQ(sequentialColor(-3.0), sequentialColor(0.0));
    EXPECT_EQ(sequentialColor(7.0), sequentialColor(1.0));
}

TEST(ColorMap, TellsSignsAndIsGreyAtZero)
{
    const ChartColor zero = divergingColor(0.0);
    EXPECT_EQ((zero >> 16) & 0xFF, zero & 0xFF);
    for (const double share : {0.2, 0.6, 1.0}) {
        EXPECT_GT((divergingColor(share) >> 16) & 0xFF, divergingColor(share) & 0xFF) << "orange";
        EXPECT_LT((divergingColor(-share) >> 16) & 0xFF, divergingColor(-share) & 0xFF) << "blue";
    }
}

TEST(HeatMap, FindsItsCells)
{
    const HeatMap map = sample();
    std::size_t column = 9;
    std::size_t row = 9;
    ASSERT_TRUE(cellAt(map, 2.5, 1.5, column, row));
    EXPECT_EQ(map.at(column, row), 0.25);
    EXPECT_FALSE(cellAt(map, 3.0, 1.0, column, row));
    EXPECT_FALSE(cellAt(map, -0.1, 1.0, column, row));
    EXPECT_FALSE(cellAt(map, std::nan(""), 1.0, column, row));
}

TEST(HeatMap, ShowsWhatIsNotPositiveOnALogarithmicScaleAsDarkest)
{
    HeatMap map = sample();
    map.scale = {"value", 1e-3, 1.0, AxisScale::Log};
    EXPECT_EQ(colorOf(map, 0.0), sequentialColor(0.0));
    EXPECT_EQ(colorOf(map, -2.0), sequentialColor(0.0));
    EXPECT_EQ(colorOf(map, 1.0), sequentialColor(1.0));
}

TEST(HeatMap, OnPaperHatchesHolesOnly)
{
    HeatMap map = sample();
    EXPECT_THAT(svgOf(map, 500, 400), Not(HasSubstr("#ececec")));
    map.values[4] = std::numeric_limits<double>::quiet_NaN(); // planted hole
    const std::string svg = svgOf(map, 500, 400);
    EXPECT_THAT(svg, HasSubstr("#ececec"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(HeatMap, AsCsvLeavesHolesEmpty)
{
    HeatMap map{"", {"", 0.0, 2.0}, {"", 0.0, 1.0}, 2, 1, {0.125, std::nan("")}, {"", 0.0, 1.0}};
    EXPECT_EQ(csvOf(map), "x,y,value\n0.5,0.5,0.125\n1.5,0.5,\n");
}

} // namespace
} // namespace reflectance
