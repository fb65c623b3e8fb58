#include "core/study/cost/instructions.h"
#include "core/study/cost/shading_cost.h"
#include "core/study/cost/timing.h"

#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

TEST(Timing, IsTheMiddleAndTheQuartiles)
{
    const Timing timing = timingOf({5.0, 1.0, 2.0, 100.0, 3.0});
    EXPECT_EQ(timing.median, 3.0) << "an outlier does not move it";
    EXPECT_EQ(timing.spread, 1.5); // quartiles 2 and 5
    EXPECT_EQ(timing.repetitions, 5);
    EXPECT_EQ(timingOf({4.0, 8.0}).median, 6.0);
    EXPECT_EQ(timingOf({}).repetitions, 0);
}

TEST(Timing, RunsTheWorkOnceMoreThanItTimesIt)
{
    int runs = 0;
    EXPECT_EQ(timed(4, byTheWall([&] { ++runs; })).repetitions, 4);
    EXPECT_EQ(runs, 5) << "the first warms up";
}

TEST(ShadingCost, IsMeasuredInEveryPrecision)
{
    const Model& model = **findModel("hybrid");
    const std::vector<double> values = flatValues(model.text, {});
    for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd}) {
        EXPECT_GT(shadingCost(model, values, precision), 0.0);
        // Not every system counts.
        EXPECT_GT(shadingInstructions(generalModel(model, values), precision).value_or(2.0), 1.0);
    }
}

TEST(Instructions, RunTheWorkWhereTheyAreCounted)
{
    volatile int sum = 0;
    const auto count = instructionsOf([&] {
        for (int i = 0; i < 1000; ++i)
            sum = sum + i;
    });
    EXPECT_GT(count.value_or(2000U), 1000U) << "at least one instruction a turn, where the system counts";
}

} // namespace
} // namespace reflectance::test
