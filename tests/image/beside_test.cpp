// Two pictures in one: every pixel is one of theirs.
#include "core/image/beside.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

Image filled(int width, int height, float value)
{
    Image image(width, height);
    std::fill(image.rgb.begin(), image.rgb.end(), value);
    std::fill(image.coverage.begin(), image.coverage.end(), value);
    return image;
}

TEST(Beside, KeepsBothAndParts)
{
    const Image both = sideBySide(filled(3, 2, 0.25F), filled(3, 2, 0.75F), 2);
    ASSERT_EQ(both.width, 8);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 8; ++x) {
            const float expected = x < 3 ? 0.25F : x < 5 ? 0.0F : 0.75F;
            EXPECT_EQ(both.at(x, y)[2], expected) << x;
            EXPECT_EQ(both.coverage[static_cast<std::size_t>(8 * y + x)], expected) << x;
        }
}

TEST(Beside, WipesAtTheDivider)
{
    const Image a = filled(10, 1, 0.0F), b = filled(10, 1, 1.0F);
    for (const auto& [divider, columns] : {std::pair{0.0, 0}, {0.3, 3}, {0.5, 5}, {1.0, 10}}) {
        const Image both = wiped(a, b, divider);
        for (int x = 0; x < 10; ++x)
            EXPECT_EQ(both.at(x, 0)[0], x < columns ? 0.0F : 1.0F) << divider << ", " << x;
    }
    EXPECT_NE(wiped(a, b, 0.3).rgb, wiped(a, b, 0.4).rgb); // planted: another divider shows
}

} // namespace
} // namespace reflectance
