// The statistics over pixels; the differences themselves are tested beside.
#include "core/image/perceived.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

/// Twenty grey pixels, of which the first `changed` differ.
Image strip(int changed)
{
    Image image(20, 1);
    std::fill(image.rgb.begin(), image.rgb.end(), 0.5F);
    std::fill_n(image.rgb.begin(), 3 * changed, 0.6F);
    std::fill_n(image.coverage.begin(), 10, 1.0F);
    return image;
}

TEST(Perceived, TheStatisticsCountPixels)
{
    const PerceivedReference reference(strip(0));
    const double one = deltaE2000(labOfDisplayed(strip(0).at(0, 0)), labOfDisplayed(strip(1).at(0, 0)));
    EXPECT_GT(one, 1.0);
    const PerceivedDifference single = reference.to(strip(1));
    EXPECT_DOUBLE_EQ(single.deltaEMean, one / 20.0);
    EXPECT_DOUBLE_EQ(single.deltaEMax, one);
    EXPECT_EQ(single.deltaEP95, 0.0) << "one pixel of twenty is the twentieth that 95 % leave out";
    EXPECT_DOUBLE_EQ(reference.to(strip(2)).deltaEP95, one);
    EXPECT_GT(single.flipMean, 0.0);
}

TEST(Perceived, OverTheObjectAlone)
{
    const PerceivedReference reference(strip(0), Over::CoveredPixels);
    const double one = reference.deltaEAt(0, strip(1));
    EXPECT_DOUBLE_EQ(reference.to(strip(5)).deltaEMean, one * 5.0 / 10.0);
    Image beside = strip(0);
    std::fill_n(beside.at(15, 0), 3, 1.0F);
    EXPECT_EQ(reference.to(beside).deltaEMax, 0.0);
}

TEST(Perceived, APictureWithoutObjectHasNoDifference)
{
    const Image empty(4, 4);
    EXPECT_EQ(PerceivedReference(empty, Over::CoveredPixels).to(empty).deltaEMax, 0.0);
}

} // namespace
} // namespace reflectance::test
