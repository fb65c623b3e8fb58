// Maps of measured surfaces: numbers where they belong, holes, and reciprocity that is kept or broken.
#include "core/study/tables/table_maps.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace reflectance {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// f = 1 + theta_i + slope theta_r on whole radians 0 .. 1.5; linear, so that interpolation is exact.
Table sloped(double slope)
{
    Table table;
    table.axes = {{0.0, 0.5, 1.0, 1.5}, {0.0, 0.5, 1.0, 1.5}};
    for (const double i : table.axes[0])
        for (const double r : table.axes[1])
            table.values.push_back(1.0 + i + slope * r);
    return table;
}

TEST(ValueMap, LooksUpTheMiddleOfEachCell)
{
    const HeatMap map = valueMap(sloped(0.25), {.logarithmic = false, .steps = 9});
    const double ten = std::numbers::pi / 18;
    for (std::size_t row = 0; row < 8; ++row)
        for (std::size_t column = 0; column < 8; ++column)
            EXPECT_NEAR(map.at(column, row),
                        1.0 + (static_cast<double>(row) + 0.5) * ten + 0.25 * (static_cast<double>(column) + 0.5) * ten,
                        1e-12);
    EXPECT_EQ(map.scale.low, 0.0);
}

TEST(ValueMap, LeavesUnmeasuredCellsOut)
{
    Table table = sloped(0.0);
    const auto holes = [](const HeatMap& map) {
        return std::count_if(map.values.begin(), map.values.end(), [](double value) { return std::isnan(value); });
    };
    const auto beyond = holes(valueMap(table, {.steps = 45}));
    EXPECT_GT(beyond, 0) << "beyond 1.5 rad nothing was measured";
    table.values[5] = nan; // planted
    EXPECT_GT(holes(valueMap(table, {.steps = 45})), beyond);
}

TEST(ValueMap, ShowsEntriesOfAMatrix)
{
    Table table;
    table.axes = {{0.0, 1.5}, {0.0, 1.5}};
    table.channels = 9;
    for (int k = 0; k < 4; ++k)
        for (int entry = 1; entry <= 9; ++entry)
            table.values.push_back(entry);
    EXPECT_EQ(valueMap(table, {.row = 0, .column = 2, .steps = 4}).at(0, 0), 3.0);
    EXPECT_EQ(valueMap(table, {.row = 2, .column = 0, .steps = 4}).at(0, 0), 7.0);
    EXPECT_EQ(valueMap(table, {.steps = 4}).at(0, 0), 5.0) << "the mean of the diagonal";
}

TEST(ValueMap, StretchesNoLogarithmOverWhatUnderflows)
{
    Table table = sloped(0.0);
    table.values[0] = 1e-300;
    const HeatMap map = valueMap(table, {.steps = 20});
    EXPECT_EQ(map.scale.scale, AxisScale::Log);
    EXPECT_GT(map.scale.low, 1e-7);
    EXPECT_LT(map.scale.low, map.scale.high);
}

TEST(PolarSlice, CutsBothSidesAndStopsAtHoles)
{
    const PolarChart chart = polarSlice(sloped(0.25), 30.0, {});
    const PolarChart::Curve& curve = chart.curves.at(0);
    const double thirty = std::numbers::pi / 6;
    for (std::size_t i = 0; i < curve.angle.size(); ++i) {
        const double theta = std::fabs(curve.angle[i]);
        if (theta <= 1.5) {
            EXPECT_NEAR(curve.radius[i], 1.0 + thirty + 0.25 * theta, 1e-12) << curve.angle[i];
        } else {
            EXPECT_TRUE(std::isnan(curve.radius[i])) << "beyond 1.5 rad nothing was measured";
        }
    }
    EXPECT_GT(chart.largest, 1.0 + thirty + 0.25 * 1.48);
}

TEST(ResidualMap, IsZeroForASymmetricTableAndSignedForOthers)
{
    const HeatMap none = residualMap(sloped(1.0), {.steps = 18});
    for (const double value : none.values) {
        if (!std::isnan(value)) {
            EXPECT_NEAR(value, 0.0, 1e-12);
        }
    }
    const HeatMap some = residualMap(sloped(0.0), {.steps = 18}); // planted: f depends on theta_i alone
    ASSERT_TRUE(some.diverging);
    EXPECT_GT(some.at(2, 10), 0.1) << "theta_i above theta_r";
    EXPECT_NEAR(some.at(2, 10), -some.at(10, 2), 1e-12);
    EXPECT_EQ(some.scale.low, -some.scale.high);
}

} // namespace
} // namespace reflectance
