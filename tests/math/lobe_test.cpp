#include "core/math/lobe.h"

#include <gtest/gtest.h>

namespace reflectance {
namespace {

Vec3d at(double angle)
{
    return {std::sin(angle), 0.0, std::cos(angle)};
}

TEST(Lobe, IsTheCosinePowerOnBothSidesOfItsSwitch)
{
    const Vec3d R{0, 0, 1};
    for (const double angle : {0.3, 1.0471, 1.0472, 1.3})
        for (const double n : {0.5, 1.0, 7.0, 30.0})
            // log(lobe) = n log(cos): n |log cos| <= 40 here, so 40 eps and a few roundings.
            EXPECT_NEAR(lobe(R, at(angle), n) / std::pow(std::cos(angle), n), 1.0, 64.0 * 0x1p-53) << angle << ' ' << n;
}

TEST(Lobe, KeepsItsDigitsAtLargeExponents)
{
    // cos(1e-3)^1e6 and cos(1e-3)^1e7; the exponent n log(cos) is 0.5 and 5, the angle is known to an ulp.
    EXPECT_NEAR(lobe({0, 0, 1}, at(1e-3), 1e6), 0.6065306091684, 1e-12);
    EXPECT_NEAR(lobe({0, 0, 1}, at(1e-3), 1e7), 0.00673794138413, 1e-13);
}

/// What the lobe is for: the textbook form in float is far outside what the conditioned form keeps.
TEST(Lobe, BeatsThePowerOfTheDotProductInFloat)
{
    const Vec3f R(0.0F, 0.0F, 1.0F);
    const Vec3f V(at(1e-3));
    const double truth = 0.6065306091684;
    // Rounding V to float alone moves the value by n delta eps = 1e6 * 1e-3 * 2^-24.
    EXPECT_NEAR(lobe(R, V, 1e6F) / truth, 1.0, 2e-4);
    EXPECT_GT(std::fabs(std::pow(dot(R, V), 1e6F) / truth - 1.0), 5e-3);
}

TEST(Gate, IsOpenAboveZeroOnly)
{
    EXPECT_EQ(gate(1e-300, 5.0), 5.0);
    EXPECT_EQ(gate(0.0, 5.0), 0.0);
    EXPECT_EQ(gate(-0.0, 5.0), 0.0);
    EXPECT_EQ(gate(-1.0, Vec3d(1, 2, 3)), Vec3d());
}

TEST(Mirrored, TurnsAboutTheNormal)
{
    EXPECT_EQ(mirrored(Vec3d(0, 0, 1), Vec3d(0.6, 0.0, 0.8)), Vec3d(-0.6, 0.0, 0.8));
}

} // namespace
} // namespace reflectance
