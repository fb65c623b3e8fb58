// What separates two pictures: figures over the object against hand-computed ones, the map's colours, its scale.
#include "app/explorer/difference.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace reflectance::explorer {
namespace {

/// 10 x 10, the object covers the upper half, where a channel is `value`.
Image halfCovered(float value)
{
    Image image(10, 10);
    for (std::size_t pixel = 0; pixel < 50; ++pixel) {
        image.coverage[pixel] = 1.0F;
        std::fill_n(&image.rgb[3 * pixel], 3, value);
    }
    return image;
}

DifferencePicture differenceBetween(const Image& a, const Image& b, double exposure = 0.0)
{
    Progress progress;
    const auto made = differenceOf(a, b, exposure, true, progress);
    EXPECT_TRUE(made);
    return made.value_or(DifferencePicture());
}

TEST(Difference, OfEqualPicturesIsExactlyZero)
{
    const DifferencePicture none = differenceBetween(halfCovered(0.3F), halfCovered(0.3F));
    EXPECT_TRUE(none.figures.identical);
    EXPECT_EQ(none.figures.rmse, 0.0);
    EXPECT_EQ(none.figures.maxAbs, 0.0);
    EXPECT_EQ(none.figures.deltaEMax, 0.0);
}

TEST(Difference, IsTakenOverTheObjectAlone)
{
    Image b = halfCovered(0.5F);
    b.rgb[0] = 0.75F; // one channel of one pixel
    const DifferencePicture found = differenceBetween(halfCovered(0.5F), b);
    EXPECT_FALSE(found.figures.identical);
    EXPECT_EQ(found.figures.pixels, 50U);
    EXPECT_DOUBLE_EQ(found.figures.maxAbs, 0.25);
    EXPECT_NEAR(found.figures.rmse, std::sqrt(0.0625 / 150.0), 1e-15); // over 3 x 50 channels, some roundings
    EXPECT_EQ(found.figures.deltaEP95, 0.0) << "fewer than one pixel in twenty differ";
    EXPECT_GT(*found.figures.deltaEMax, 1.0);
}

TEST(Difference, OfARegionLooksNowhereElse)
{
    Image b = halfCovered(0.5F);
    b.rgb[0] = 0.75F; // the pixel in the corner
    Progress progress;
    const auto figuresIn = [&](const Region& region) {
        return differenceOf(halfCovered(0.5F), b, 0.0, true, progress, region)->figures;
    };
    const DifferenceFigures corner = figuresIn({0.0, 0.0, 0.2, 0.2});
    EXPECT_EQ(corner.pixels, 4U);
    EXPECT_DOUBLE_EQ(corner.maxAbs, 0.25);
    EXPECT_NEAR(corner.rmse, std::sqrt(0.0625 / 12.0), 1e-15);
    EXPECT_TRUE(corner.ofRegion);
    const DifferenceFigures beside = figuresIn({0.5, 0.0, 1.0, 1.0});
    EXPECT_TRUE(beside.identical);
    EXPECT_EQ(beside.flipMean, 0.0);
    EXPECT_EQ(cropped(b, {0.9, 0.9, 0.9, 0.9}).pixels(), 1U) << "never nothing";
    EXPECT_EQ(cropped(b, {1.0, 1.0, 1.0, 1.0}).pixels(), 1U);
}

TEST(Difference, TellsHowStronglyThePicturesWouldFlicker)
{
    const auto none = differenceBetween(halfCovered(0.3F), halfCovered(0.3F)).figures.flipMean;
    const auto little = differenceBetween(halfCovered(0.3F), halfCovered(0.32F)).figures.flipMean;
    const auto much = differenceBetween(halfCovered(0.3F), halfCovered(0.9F)).figures.flipMean;
    ASSERT_TRUE(none && little && much);
    EXPECT_EQ(*none, 0.0);
    EXPECT_GT(*little, 0.0);
    EXPECT_GT(*much, *little);
    EXPECT_LE(*much, 1.0);
}

TEST(Difference, SeesWhatTheDisplayShows)
{
    // Beyond white both are clipped; two stops down they are not.
    EXPECT_EQ(differenceBetween(halfCovered(2.0F), halfCovered(3.0F)).figures.deltaEMax, 0.0);
    EXPECT_GT(*differenceBetween(halfCovered(2.0F), halfCovered(3.0F), -2.0).figures.deltaEMax, 5.0);
}

TEST(Difference, MapIsRedWhereBIsBrighterBlueWhereDarkerAndDarkBesideTheObject)
{
    const DifferencePicture up = differenceBetween(halfCovered(0.2F), halfCovered(0.25F));
    EXPECT_GT(up.rgb[0], up.rgb[2]);
    const DifferencePicture down = differenceBetween(halfCovered(0.25F), halfCovered(0.2F));
    EXPECT_LT(down.rgb[0], down.rgb[2]);
    EXPECT_LT(up.rgb[3 * 99], 40);
    EXPECT_DOUBLE_EQ(up.scale, 0.05);
}

TEST(Difference, ScaleIsRoundAndNotBelowTheLargest)
{
    EXPECT_DOUBLE_EQ(roundScale(0.05), 0.05);
    EXPECT_DOUBLE_EQ(roundScale(0.051), 0.1);
    EXPECT_DOUBLE_EQ(roundScale(3.0), 5.0);
    EXPECT_DOUBLE_EQ(roundScale(1e-7), 1e-7);
    EXPECT_EQ(roundScale(0.0), 1.0);
    EXPECT_EQ(roundScale(std::numeric_limits<double>::quiet_NaN()), 1.0);
}

TEST(Difference, IsGivenUpWhereNobodyWantsIt)
{
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(differenceOf(halfCovered(0.1F), halfCovered(0.2F), 0.0, true, progress));
}

} // namespace
} // namespace reflectance::explorer
