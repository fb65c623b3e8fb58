#include "core/math/quantile.h"

#include <gtest/gtest.h>
#include <limits>

namespace reflectance {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Quantile, IsAStraightLineBetweenNeighbours)
{
    EXPECT_EQ(quantileOf({3.0}, 0.95), 3.0);
    EXPECT_EQ(quantileOf({4, 1, 3, 2, 5}, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(quantileOf({4, 1, 3, 2, 5}, 0.95), 4.8);
    EXPECT_EQ(quantileOf({4, 1, 3, 2, 5}, 1.0), 5.0);
    EXPECT_EQ(quantileOf({}, 0.5), 0.0);
}

TEST(Quantile, OfInfinitiesIsNoNan)
{
    EXPECT_EQ(quantileOf({1.0, infinity, infinity}, 0.25), infinity);
    EXPECT_EQ(quantileOf({1.0, infinity, infinity}, 0.75), infinity);
    EXPECT_EQ(quantileOf({1.0, 2.0, infinity}, 0.5), 2.0);
}

TEST(Median, LeavesHalfOnEitherSide)
{
    EXPECT_EQ(medianOf({4, 1, 3, 2, 5}), 3.0);
    EXPECT_EQ(medianOf({4, 1, 3, 2}), 2.5);
    EXPECT_EQ(medianOf({}), 0.0);
}

TEST(LeastCovering, IsTheSmallestThatTheShareDoesNotExceed)
{
    std::vector<double> hundred;
    for (int i = 1; i <= 100; ++i)
        hundred.push_back(i);
    EXPECT_EQ(leastCovering(hundred, 0.95), 95.0);
    EXPECT_EQ(leastCovering(hundred, 0.951), 96.0);
    EXPECT_EQ(leastCovering(hundred, 1.0), 100.0);
    EXPECT_EQ(leastCovering({7.0, infinity}, 0.5), 7.0);
    EXPECT_EQ(leastCovering({7.0, infinity}, 0.6), infinity);
    EXPECT_EQ(leastCovering({}, 0.5), 0.0);
    EXPECT_NE(leastCovering(hundred, 0.95), quantileOf(hundred, 0.95)) << "two things of nearly one name";
}

} // namespace
} // namespace reflectance
