#include "core/image/upscale.h"

#include <gtest/gtest.h>

namespace reflectance {
namespace {

/// A plane a x + b y + c over the middles of pixels, x and y in shares of the picture.
Image plane(int width, int height, double a, double b, double c)
{
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                image.at(x, y)[channel] = static_cast<float>(a * (x + 0.5) / width + b * (y + 0.5) / height + c);
    return image;
}

TEST(Upscaled, KeepsAPlaneInside)
{
    const Image fine = upscaled(plane(8, 6, 0.5, 0.25, 0.1), 21, 17); // no whole multiple
    const Image exact = plane(21, 17, 0.5, 0.25, 0.1);
    for (int y = 2; y < 15; ++y)
        for (int x = 2; x < 19; ++x)
            EXPECT_NEAR(fine.at(x, y)[0], exact.at(x, y)[0], 2e-7); // a few roundings of values below 1
}

TEST(Upscaled, KeepsTheRimAndAConstant)
{
    const Image fine = upscaled(plane(3, 3, 0.9, 0.0, 0.0), 12, 12);
    EXPECT_EQ(fine.at(0, 0)[0], plane(3, 3, 0.9, 0.0, 0.0).at(0, 0)[0]) << "nothing is extrapolated";
    const Image flat = upscaled(plane(1, 1, 0.0, 0.0, 0.7), 5, 4);
    for (const float value : flat.rgb)
        EXPECT_EQ(value, 0.7F);
}

TEST(Upscaled, TheSameSizeIsTheSamePicture)
{
    const Image image = plane(7, 5, 0.3, 0.6, 0.0);
    EXPECT_EQ(upscaled(image, 7, 5).rgb, image.rgb);
    EXPECT_NE(upscaled(image, 8, 5).rgb, image.rgb) << "the planted fault: another size";
}

} // namespace
} // namespace reflectance
