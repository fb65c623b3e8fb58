// Axes: places, round ticks, and the limits that hold all numbers.
#include "core/chart/chart.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace reflectance {
namespace {

std::vector<double> valuesOf(const std::vector<Tick>& ticks)
{
    std::vector<double> values;
    for (const Tick& tick : ticks)
        values.push_back(tick.value);
    return values;
}

TEST(Axis, PlacesItsEndsAtZeroAndOneAndGoesBack)
{
    for (const Axis& axis : {Axis{"", -3.0, 5.0, AxisScale::Linear}, Axis{"", 1e-9, 1e3, AxisScale::Log}}) {
        EXPECT_EQ(shareAlong(axis, axis.low), 0.0);
        EXPECT_NEAR(shareAlong(axis, axis.high), 1.0, 1e-15);
        for (const double share : {0.0, 0.25, 0.7, 1.0, 1.3})
            EXPECT_NEAR(shareAlong(axis, valueAlong(axis, share)), share, 1e-14); // a logarithm's rounding
    }
    EXPECT_TRUE(std::isnan(shareAlong({"", 1e-3, 1.0, AxisScale::Log}, 0.0)));
}

TEST(Axis, HasRoundTicks)
{
    EXPECT_THAT(valuesOf(ticksOf({"", 0.0, 90.0}, 5)), testing::ElementsAre(0, 20, 40, 60, 80));
    EXPECT_THAT(valuesOf(ticksOf({"", -0.1, 1.05}, 6)), testing::ElementsAre(0, 0.2, 0.4, 0.6000000000000001, 0.8, 1));
    EXPECT_THAT(valuesOf(ticksOf({"", -90.0, 90.0, AxisScale::Linear, 30.0}, 7)),
                testing::ElementsAre(-90, -60, -30, 0, 30, 60, 90));
    const std::vector<Tick> decades = ticksOf({"", 1e-9, 1.0, AxisScale::Log}, 5);
    EXPECT_THAT(decades.front().text, "1e-9");
    EXPECT_LE(decades.size(), 5U);
    EXPECT_THAT(valuesOf(ticksOf({"", 0.9, 11.0, AxisScale::Log}, 9)), testing::ElementsAre(1, 2, 5, 10));
}

TEST(Axis, NeverHasMoreTicksThanAskedForNorNone)
{
    for (const double low : {-1e6, -0.37, 0.0, 12.3})
        for (const double length : {1e-6, 0.9, 7.7, 3e9})
            for (const int most : {2, 5, 11}) {
                const std::size_t count = ticksOf({"", low, low + length}, most).size();
                EXPECT_LE(count, static_cast<std::size_t>(most)) << low << ' ' << length;
                EXPECT_GE(count, 1U) << low << ' ' << length;
            }
}

TEST(Axis, HoldsEveryFiniteNumber)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Axis linear = axisAround("y", {2.0, nan, -1.0, std::numeric_limits<double>::infinity()});
    EXPECT_LT(linear.low, -1.0);
    EXPECT_GT(linear.high, 2.0);
    const Axis log = axisAround("y", {0.0, 1e-7, 3.0}, AxisScale::Log);
    EXPECT_GT(log.low, 0.0);
    EXPECT_LT(log.low, 1e-7);
    for (const Axis& axis : {axisAround("", {}), axisAround("", {5.0}), axisAround("", {nan}, AxisScale::Log)})
        EXPECT_LT(axis.low, axis.high) << "an axis without length cannot be drawn";
}

TEST(Axis, WithoutLengthHasNoTicks)
{
    EXPECT_TRUE(ticksOf({"", 1.0, 1.0}, 5).empty());
    EXPECT_TRUE(ticksOf({"", 0.0, std::numeric_limits<double>::infinity()}, 5).empty());
    EXPECT_TRUE(ticksOf({"", -1.0, 1.0, AxisScale::Log}, 5).empty());
}

} // namespace
} // namespace reflectance
