// The figures between two pictures, worked out by hand.
#include "core/image/compare.h"
#include "tests/image/samples.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Image row(const std::vector<float>& rgb)
{
    Image image(static_cast<int>(rgb.size() / 3), 1);
    image.rgb = rgb;
    return image;
}

std::array<int, 3> colourOf(float difference, double scale)
{
    const auto codes = differenceMap(row({0, 0, 0}), row({difference, difference, difference}), scale);
    return {codes[0], codes[1], codes[2]};
}

TEST(Compare, APictureEqualsItself)
{
    const Image image = oddImage(9, 5);
    const auto c = compared(image, image);
    ASSERT_TRUE(c);
    EXPECT_TRUE(c->identical);
    EXPECT_EQ(c->maxAbs, 0.0);
    EXPECT_EQ(c->rmse, 0.0);
    EXPECT_EQ(c->maxRelative, 0.0);
    EXPECT_EQ(c->differing, 0U);
}

TEST(Compare, OneChangedBitAnywhereWouldBeFound)
{
    const Image image = oddImage(9, 5);
    for (std::size_t i = 9; i < image.rgb.size(); ++i) {
        Image changed = image;
        changed.rgb[i] = std::nextafter(changed.rgb[i], 100.0F);
        const auto c = compared(image, changed);
        EXPECT_FALSE(c->identical);
        EXPECT_EQ(c->differing, 1U);
        EXPECT_EQ(static_cast<std::size_t>(3 * (c->y * image.width + c->x) + c->channel), i);
    }
}

TEST(Compare, FiguresOfAHandMadePair)
{
    const auto c = compared(row({1, 2, 3, 4, 5, 6}), row({1, 2.5F, 3, 4, 5, 4}));
    ASSERT_TRUE(c);
    EXPECT_EQ(c->maxAbs, 2.0);
    EXPECT_EQ(c->x, 1);
    EXPECT_EQ(c->y, 0);
    EXPECT_EQ(c->channel, 2);
    EXPECT_EQ(c->meanAbs, 2.5 / 6.0);
    EXPECT_EQ(c->rmse, std::sqrt(4.25 / 6.0));
    EXPECT_EQ(c->maxRelative, 2.0 / 6.0);
    EXPECT_EQ(c->differing, 2U);
}

TEST(Compare, RelativeFiguresHaveAFloor)
{
    const auto c = compared(row({0, 0, 0}), row({1e-4F, 0, 0}));
    EXPECT_EQ(c->maxRelative, double{1e-4F} / relativeFloor);
}

TEST(Compare, NonFiniteValuesAreFarFromFiniteOnes)
{
    for (const float odd : {infinity, -infinity, nan}) {
        const auto c = compared(row({1, 1, 1}), row({1, odd, 1}));
        EXPECT_EQ(c->maxAbs, HUGE_VAL);
        EXPECT_EQ(c->maxRelative, HUGE_VAL);
        EXPECT_EQ(compared(row({1, odd, 1}), row({1, 1, 1}))->maxRelative, HUGE_VAL);
        EXPECT_EQ(compared(row({odd, 1, 1}), row({odd, 1, 1}))->maxAbs, 0.0);
    }
    EXPECT_EQ(compared(row({infinity, 0, 0}), row({-infinity, 0, 0}))->maxAbs, HUGE_VAL);
    EXPECT_EQ(compared(row({infinity, 0, 0}), row({nan, 0, 0}))->maxAbs, HUGE_VAL);
}

TEST(Compare, CountsNegativeAndNonFinitePixelsOfEach)
{
    const auto c = compared(row({-1, -2, 0, nan, -1, 0}), row({0, 0, 0, infinity, nan, 1}));
    EXPECT_EQ(c->a.negative, 2U);
    EXPECT_EQ(c->a.nonFinite, 1U);
    EXPECT_EQ(c->b.negative, 0U);
    EXPECT_EQ(c->b.nonFinite, 1U);
}

TEST(Compare, AZeroOfOtherSignIsNoDifferenceButNotIdentical)
{
    const auto c = compared(row({0.0F, 0, 0}), row({-0.0F, 0, 0}));
    EXPECT_FALSE(c->identical);
    EXPECT_EQ(c->differing, 0U);
    EXPECT_EQ(c->maxAbs, 0.0);
}

TEST(Compare, SizesMustMatch)
{
    const auto c = compared(Image(2, 3), Image(3, 2));
    ASSERT_FALSE(c);
    EXPECT_NE(c.error().message.find("2 x 3 against 3 x 2"), std::string::npos);
}

TEST(DifferenceMap, IsWhiteWhereEqualBlueWhereDarkerRedWhereBrighter)
{
    EXPECT_EQ(colourOf(0.0F, 1.0), (std::array<int, 3>{247, 247, 247}));
    EXPECT_EQ(colourOf(1.0F, 1.0), (std::array<int, 3>{165, 20, 40}));
    EXPECT_EQ(colourOf(-1.0F, 1.0), (std::array<int, 3>{20, 80, 155}));
    EXPECT_EQ(colourOf(9.0F, 1.0), colourOf(1.0F, 1.0)) << "the scale ends at full colour";
    EXPECT_EQ(colourOf(0.25F, 0.5), colourOf(0.5F, 1.0)) << "colours follow the stated scale";
    EXPECT_EQ(colourOf(nan, 1.0), (std::array<int, 3>{0, 0, 0}));
    EXPECT_EQ(colourOf(infinity, 1.0), colourOf(1.0F, 1.0));
}

TEST(DifferenceMap, LightnessFallsToBothSides)
{
    const auto lightness = [](std::array<int, 3> c) { return 2 * c[0] + 7 * c[1] + c[2]; };
    for (const float side : {-1.0F, 1.0F})
        for (float t = 0.0F; t < 0.95F; t += 0.1F)
            EXPECT_GT(lightness(colourOf(side * t, 1.0)), lightness(colourOf(side * (t + 0.1F), 1.0)));
}

} // namespace
} // namespace reflectance::test
