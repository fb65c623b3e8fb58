// dE2000 against the published pairs, and colours whose CIELAB values are known.
#include "core/image/colour_difference.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

struct Pair {
    Lab one, other;
    double expected;
};

/// From Sharma, Wu & Dalal 2005, table 1 (printed to 4 digits), which exercises each branch of the hue's mean and
/// difference; the last pair, of colours beyond any display, is the one of colour-science's tests.
const Pair published[] = {
    {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
    {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
    {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
    {{50, 0, 0}, {50, -1, 2}, 2.3669},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
    {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
    {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
    {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
    {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
    {{100, 21.57210357, 272.22819350}, {100, 426.67945353, 72.39590835}, 94.03564903},
};

TEST(DeltaE2000, AgreesWithThePublishedPairs)
{
    for (const Pair& pair : published) {
        // Half a unit of the last printed digit.
        EXPECT_NEAR(deltaE2000(pair.one, pair.other), pair.expected, 5e-5);
        EXPECT_DOUBLE_EQ(deltaE2000(pair.one, pair.other), deltaE2000(pair.other, pair.one));
    }
}

TEST(DeltaE2000, IsZeroForEqualColoursOnly)
{
    for (const Pair& pair : published) {
        EXPECT_EQ(deltaE2000(pair.one, pair.one), 0.0);
        EXPECT_GT(deltaE2000(pair.one, pair.other), 0.5);
    }
}

/// The planted fault: without the turn of the blue region the first pair would come out at more than 2.0425.
TEST(DeltaE2000, TheBlueRegionIsTurned)
{
    const double dC = 79.8200 - 82.7485;
    const double withoutTurn = std::fabs(dC) / (1.0 + 0.045 * 81.28);
    EXPECT_GT(std::fabs(deltaE2000(published[0].one, published[0].other) - withoutTurn), 0.5);
}

TEST(Lab, WhiteGreyAndBlack)
{
    const float white[] = {1, 1, 1}, black[] = {0, 0, 0}, over[] = {7, 3, 1}, odd[] = {NAN, -1, 0};
    const Lab w = labOfDisplayed(white);
    // The matrix has 7 digits, the white is its own row sums: what remains is double rounding times 500.
    EXPECT_NEAR(w.L, 100.0, 1e-12);
    EXPECT_NEAR(w.a, 0.0, 1e-12);
    EXPECT_NEAR(w.b, 0.0, 1e-12);
    EXPECT_NEAR(labOfDisplayed(black).L, 0.0, 1e-12);
    EXPECT_EQ(labOfDisplayed(over).L, w.L);
    EXPECT_EQ(labOfDisplayed(odd).L, labOfDisplayed(black).L);
    // 18.4187 % is where L* = 50: ((50 + 16) / 116)^3.
    const float middle[] = {0.184187F, 0.184187F, 0.184187F};
    EXPECT_NEAR(labOfDisplayed(middle).L, 50.0, 1e-4);
}

/// The sRGB primaries in CIELAB, as any colour table prints them.
TEST(Lab, Primaries)
{
    const float green[] = {0, 1, 0}, blue[] = {0, 0, 1};
    EXPECT_NEAR(labOfDisplayed(green).L, 87.735, 0.01);
    EXPECT_NEAR(labOfDisplayed(green).a, -86.183, 0.02);
    EXPECT_NEAR(labOfDisplayed(green).b, 83.180, 0.02);
    EXPECT_NEAR(labOfDisplayed(blue).L, 32.297, 0.01);
    EXPECT_NEAR(labOfDisplayed(blue).a, 79.188, 0.02);
    EXPECT_NEAR(labOfDisplayed(blue).b, -107.860, 0.02);
}

} // namespace
} // namespace reflectance::test
