// FLIP where its value is known in closed form, and what any measure of visible difference must do.
#include "core/image/flip.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

Image flat(float r, float g, float b, int side = 40)
{
    Image image(side, side);
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        image.rgb[i] = r;
        image.rgb[i + 1] = g;
        image.rgb[i + 2] = b;
    }
    return image;
}

Image dotted(float value, int every)
{
    Image image = flat(0.2F, 0.2F, 0.2F);
    for (int y = 0; y < image.height; y += every)
        for (int x = 0; x < image.width; x += every)
            std::fill_n(image.at(x, y), 3, value);
    return image;
}

TEST(Flip, EqualPicturesDoNotDiffer)
{
    const Image image = dotted(0.9F, 5);
    EXPECT_EQ(FlipReference(image).meanOf(image), 0.0);
}

/// Flat pictures have no features and no filter changes them, so only the colour counts: HyAB^0.7 mapped to 0 .. 1.
/// Black to white is 100^0.7 of at most HyAB(green, blue)^0.7, from the primaries' CIELAB values, chroma times L/100.
TEST(Flip, BlackAndWhiteInClosedForm)
{
    const double da = -0.87735 * 86.183 - 0.32297 * 79.188;
    const double db = 0.87735 * 83.180 + 0.32297 * 107.860;
    const double largest = std::pow(87.735 - 32.297 + std::hypot(da, db), 0.7);
    const double knee = 0.4 * largest;
    const double expected = 0.95 + 0.05 * (std::pow(100.0, 0.7) - knee) / (largest - knee);
    EXPECT_NEAR(expected, 0.96738, 1e-4) << "the value that the method's own tests give";
    // The primaries above have 5 digits; the planes are float.
    EXPECT_NEAR(FlipReference(flat(0, 0, 0)).meanOf(flat(1, 1, 1)), expected, 1e-4);
    // Green against blue reaches 1, with and without what no display can show.
    EXPECT_NEAR(FlipReference(flat(-3, 8, -1)).meanOf(flat(0, 0, 1)), 1.0, 1e-5);
}

TEST(Flip, GrowsWithTheDifference)
{
    const FlipReference reference(dotted(0.2F, 5));
    double last = 0.0;
    for (const float value : {0.21F, 0.25F, 0.4F, 0.8F}) {
        const double found = reference.meanOf(dotted(value, 5));
        EXPECT_GT(found, last);
        last = found;
    }
}

/// From afar the eye averages a fine pattern away: it looks like its mean. Up close it does not.
TEST(Flip, FinePatternsVanishWithDistance)
{
    const Image pattern = dotted(0.3F, 2); // a quarter of the pixels
    const Image mean = flat(0.225F, 0.225F, 0.225F);
    const double close = FlipReference(mean, 8.0).meanOf(pattern);
    const double far = FlipReference(mean, 67.0).meanOf(pattern);
    EXPECT_LT(far, 0.5 * close);
}

TEST(Flip, IsSymmetricAndStaysWithinOne)
{
    const Image a = dotted(1.0F, 3);
    const Image b = flat(0.9F, 0.1F, 0.2F);
    EXPECT_NEAR(FlipReference(a).meanOf(b), FlipReference(b).meanOf(a), 1e-7);
    for (const float error : FlipReference(a).mapOf(b)) {
        EXPECT_GE(error, 0.0F);
        EXPECT_LE(error, 1.0F);
    }
}

/// The planted fault: a moved dot must be seen where it was and where it went, and nowhere far from both.
TEST(Flip, SaysWhere)
{
    Image a = flat(0.1F, 0.1F, 0.1F, 60);
    Image b = a;
    std::fill_n(a.at(10, 10), 3, 1.0F);
    std::fill_n(b.at(45, 45), 3, 1.0F);
    const auto map = FlipReference(a).mapOf(b);
    EXPECT_GT(map[10 * 60 + 10], 0.1F);
    EXPECT_GT(map[45 * 60 + 45], 0.1F);
    EXPECT_EQ(map[10 * 60 + 45], 0.0F);
}

} // namespace
} // namespace reflectance::test
