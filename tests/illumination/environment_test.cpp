// The surroundings as a function of direction.
#include "core/illumination/environment.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

/// 8 x 4 texels; red counts columns, green counts rows, blue is 1.
std::shared_ptr<const Image> numberedMap()
{
    auto image = std::make_shared<Image>(8, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            float* rgb = image->at(x, y);
            rgb[0] = static_cast<float>(x);
            rgb[1] = static_cast<float>(y);
            rgb[2] = 1.0F;
        }
    return image;
}

Environment mapOf(std::shared_ptr<const Image> image)
{
    Environment environment;
    environment.kind = EnvironmentKind::Map;
    environment.map = std::move(image);
    return environment;
}

/// Direction of the texel coordinates (0,0) .. (W,H), written from the convention and apart from the lookup:
/// the column runs from +z over -x, -z, +x back to +z.
Vec3d directionOf(double column, double row, int width, int height)
{
    const double azimuth = (column / width - 0.5) * 2.0 * pi;
    const double polar = row / height * pi;
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

double distanceOf(const Vec3d& a, const Vec3d& b)
{
    return length(a - b);
}

/// The largest miss of a lookup at the texel centres of the numbered map.
template <class Lookup> double worstAtTexelCentres(Lookup lookup)
{
    double worst = 0.0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            worst = std::max(worst, distanceOf(lookup(directionOf(x + 0.5, y + 0.5, 8, 4)), Vec3d(x, y, 1)));
    return worst;
}

TEST(Environment, NoneIsBlackAndConstantIsItsColour)
{
    Environment environment;
    environment.radiance = {3, 2, 1};
    environment.kind = EnvironmentKind::None;
    EXPECT_EQ(radianceFrom(environment, Vec3d(0, 1, 0)), Vec3d());
    environment.kind = EnvironmentKind::Constant;
    EXPECT_EQ(radianceFrom(environment, Vec3d(0.6, 0, -0.8)), Vec3d(3, 2, 1));
    EXPECT_EQ(radianceFrom(environment, Vec3f(0.6F, 0, -0.8F)), Vec3f(3, 2, 1));
}

TEST(Environment, AMapShowsItsTexelsAtTheirCentres)
{
    const Environment environment = mapOf(numberedMap());
    // Angles to a few eps, times 8 columns times a step of at most 7 at the seam.
    EXPECT_LT(worstAtTexelCentres([&](const Vec3d& d) { return radianceFrom(environment, d); }), 1e-13);
}

TEST(Environment, AMapSeenFromOutsideWouldBeFound)
{
    const Environment environment = mapOf(numberedMap());
    EXPECT_GT(worstAtTexelCentres([&](const Vec3d& d) { return radianceFrom(environment, Vec3d(-d.x, d.y, d.z)); }),
              1.0);
}

TEST(Environment, TheCentreColumnLiesTowardsMinusZAndPlusXToItsRight)
{
    const Environment environment = mapOf(numberedMap());
    EXPECT_NEAR(radianceFrom(environment, Vec3d(0, 0, -1)).x, 3.5, 1e-13);
    EXPECT_NEAR(radianceFrom(environment, Vec3d(1, 0, 0)).x, 5.5, 1e-13);
    EXPECT_NEAR(radianceFrom(environment, Vec3d(-1, 0, 0)).x, 1.5, 1e-13);
    EXPECT_NEAR(radianceFrom(environment, Vec3d(0, 0, -1)).y, 1.5, 1e-13);
}

TEST(Environment, TheSeamJoinsLastAndFirstColumn)
{
    const Environment environment = mapOf(numberedMap());
    // Exactly at +z half of column 7 and half of column 0 are seen, from either side.
    EXPECT_NEAR(radianceFrom(environment, Vec3d(0.0, 0, 1)).x, 3.5, 1e-13);
    EXPECT_NEAR(radianceFrom(environment, Vec3d(-0.0, 0, 1)).x, 3.5, 1e-13);
    EXPECT_NEAR(radianceFrom(environment, Vec3d(1e-9, 0, 1)).x, radianceFrom(environment, Vec3d(-1e-9, 0, 1)).x, 1e-7);
}

TEST(Environment, ThePolesShowTheOutermostRows)
{
    const Environment environment = mapOf(numberedMap());
    EXPECT_EQ(radianceFrom(environment, Vec3d(0, 1, 0)).y, 0.0);
    EXPECT_EQ(radianceFrom(environment, Vec3d(0, -1, 0)).y, 3.0);
}

TEST(Environment, BetweenTexelsItIsBilinear)
{
    const Environment environment = mapOf(numberedMap());
    for (double column = 0.5; column <= 7.5; column += 0.13)
        for (double row = 0.5; row <= 3.5; row += 0.11)
            EXPECT_LT(
                distanceOf(radianceFrom(environment, directionOf(column, row, 8, 4)), {column - 0.5, row - 0.5, 1}),
                1e-13);
}

TEST(Environment, APositiveRotationTurnsCounterclockwiseSeenFromAbove)
{
    Environment environment = mapOf(numberedMap());
    const Vec3d before = radianceFrom(environment, Vec3d(0, 0, -1));
    environment.rotation = 90.0; // what stood at -z stands at -x
    // cos(90 degrees) is 6e-17 in double.
    EXPECT_LT(distanceOf(radianceFrom(environment, Vec3d(-1, 0, 0)), before), 1e-13);
}

TEST(Environment, RotationMovesTheStudioToo)
{
    Environment still;
    Environment turned;
    turned.rotation = 30.0;
    const double c = std::cos(pi / 6);
    const double s = std::sin(pi / 6);
    const Vec3d d = normalized(Vec3d{-0.64, 0.3, 0.55});
    EXPECT_LT(
        distanceOf(radianceFrom(turned, Vec3d(c * d.x + s * d.z, d.y, -s * d.x + c * d.z)), radianceFrom(still, d)),
        1e-12);
}

TEST(Environment, TheFactorScalesAMapPerChannel)
{
    Environment environment = mapOf(numberedMap());
    environment.radiance = {2, 10, 0.5};
    const Vec3d seen = radianceFrom(environment, directionOf(4.5, 2.5, 8, 4));
    EXPECT_LT(distanceOf(seen, {8, 20, 0.5}), 1e-12);
}

TEST(Environment, FloatLooksWhereDoubleLooks)
{
    const Environment environment = mapOf(numberedMap());
    for (double column = 0.0; column < 8.0; column += 0.07)
        for (double row = 0.0; row <= 4.0; row += 0.05) {
            const Vec3d d = directionOf(column, row, 8, 4);
            // Near a pole a rounded direction has any azimuth.
            if (std::fabs(d.y) > 0.999)
                continue;
            const Vec3d difference = Vec3d(radianceFrom(environment, Vec3f(d))) - radianceFrom(environment, d);
            // d rounds by 6e-8, 22 times that in azimuth at the last latitude; 8/2pi columns per radian, 7 per column.
            EXPECT_LT(length(difference), 3e-5) << column << ' ' << row;
        }
}

TEST(Environment, ADirectionWithoutMeaningIsNotHidden)
{
    const double nan = std::nan("");
    EXPECT_TRUE(std::isnan(radianceFrom(mapOf(numberedMap()), Vec3d(nan, 0, 1)).x));
}

} // namespace
} // namespace reflectance
