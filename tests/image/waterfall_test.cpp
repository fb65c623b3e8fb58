// Shares of a difference: closed forms, and that they always add up.
#include "core/image/waterfall.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace reflectance {
namespace {

Image ofValues(const std::vector<float>& rgb)
{
    Image image(static_cast<int>(rgb.size() / 3), 1);
    image.rgb = rgb;
    return image;
}

TEST(Waterfall, StepsAtDifferentPlacesShareByTheirSquares)
{
    const std::vector<WaterfallPicture> pictures{
        {"truth", ofValues({0, 0, 0})}, {"first", ofValues({3, 0, 0})}, {"second", ofValues({3, 4, 0})}};
    const auto waterfall = waterfallOf(pictures);
    ASSERT_TRUE(waterfall);
    ASSERT_EQ(waterfall->steps.size(), 2U);
    EXPECT_EQ(waterfall->steps[0].step, "first");
    EXPECT_DOUBLE_EQ(waterfall->steps[0].share, 9.0 / 25.0);
    EXPECT_DOUBLE_EQ(waterfall->steps[1].share, 16.0 / 25.0);
    EXPECT_DOUBLE_EQ(waterfall->steps[1].rmse, 4.0 / std::sqrt(3.0));
    EXPECT_EQ(waterfall->steps[1].maxAbs, 4.0);
    EXPECT_DOUBLE_EQ(waterfall->rmse, 5.0 / std::sqrt(3.0));
}

TEST(Waterfall, WhatUndoesAnotherStepIsNegative)
{
    const std::vector<WaterfallPicture> pictures{
        {"truth", ofValues({0, 0, 0})}, {"up", ofValues({3, 3, 3})}, {"down", ofValues({2, 2, 2})}};
    const auto waterfall = waterfallOf(pictures);
    EXPECT_DOUBLE_EQ(waterfall->steps[0].share, 1.5);
    EXPECT_DOUBLE_EQ(waterfall->steps[1].share, -0.5);
}

TEST(Waterfall, SharesAddUpToOneAndStepsToTheWhole)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(-1.0F, 1.0F);
    std::vector<WaterfallPicture> pictures;
    for (const char* step : {"truth", "a", "b", "c", "d", "e"}) {
        std::vector<float> rgb(3 * 500);
        for (float& channel : rgb)
            channel = value(random);
        pictures.push_back({step, ofValues(rgb)});
    }
    const auto waterfall = waterfallOf(pictures);
    double sum = 0.0;
    for (const WaterfallStep& step : waterfall->steps)
        sum += step.share;
    EXPECT_NEAR(sum, 1.0, 1e-12); // 7500 sums of products
    // Planted: a waterfall that lost a step would not add up.
    EXPECT_GT(std::fabs(sum - waterfall->steps[2].share - 1.0), 1e-6);
}

TEST(Waterfall, LeavesOutWhatIsNotFiniteAndEqualPicturesHaveNoShares)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<WaterfallPicture> pictures{
        {"truth", ofValues({1, nan, 1})}, {"a", ofValues({1, 1, 1})}, {"b", ofValues({1, 1, INFINITY})}};
    const auto waterfall = waterfallOf(pictures);
    EXPECT_EQ(waterfall->leftOut, 2U);
    EXPECT_EQ(waterfall->rmse, 0.0);
    EXPECT_EQ(waterfall->steps[0].share, 0.0);
}

TEST(Waterfall, RefusesWhatIsNoLadder)
{
    EXPECT_FALSE(waterfallOf({}));
    const std::vector<WaterfallPicture> one{{"truth", Image(1, 1)}};
    EXPECT_FALSE(waterfallOf(one));
    const std::vector<WaterfallPicture> sizes{{"truth", Image(1, 1)}, {"a", Image(2, 1)}};
    EXPECT_FALSE(waterfallOf(sizes));
}

} // namespace
} // namespace reflectance
