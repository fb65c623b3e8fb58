// What of a light arrives at a point.
#include "core/illumination/light.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace reflectance {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

Light directional(const Vec3d& direction)
{
    Light light;
    light.direction = direction;
    light.intensity = {3.0, 2.0, 1.0};
    return light;
}

Light pointAt(const Vec3d& position, const Vec3d& intensity = {4.0, 2.0, 1.0})
{
    Light light;
    light.kind = LightKind::Point;
    light.position = position;
    light.intensity = intensity;
    return light;
}

bool isFinite(const Vec3d& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Whether the intensities at distances 1, 2 and 10 follow 1/r^2.
template <class IntensityAt> bool fallsWithTheSquare(IntensityAt at)
{
    bool holds = true;
    for (const double r : {2.0, 10.0})
        // The division and the square round once each.
        holds = holds && std::fabs(at(r) * r * r / at(1.0) - 1.0) <= 4 * eps;
    return holds;
}

TEST(Light, ADirectionalLightIsTheSameEverywhere)
{
    const Light light = directional({0, 0, 7});
    for (const Vec3d& point : {Vec3d{}, Vec3d{1, 2, 3}, Vec3d{1e9, -1e9, 0}}) {
        EXPECT_EQ(arrivalAt(light, point).L, Vec3d(0, 0, 1));
        EXPECT_EQ(arrivalAt(light, point).I, light.intensity);
    }
}

TEST(Light, ADirectionMayHaveAnyLength)
{
    EXPECT_EQ(arrivalAt(directional({0, 1e200, 0}), {}).L, Vec3d(0, 1, 0));
    EXPECT_EQ(arrivalAt(directional({5e-324, 0, 0}), {}).L, Vec3d(1, 0, 0));
}

TEST(Light, APointLightFallsWithTheSquareOfTheDistance)
{
    EXPECT_TRUE(fallsWithTheSquare([](double r) { return arrivalAt(pointAt({0, r, 0}), {}).I.x; }));
    EXPECT_EQ(arrivalAt(pointAt({0, 2, 0}), {}).I, Vec3d(1.0, 0.5, 0.25));
}

TEST(Light, AFallWithTheDistanceAloneWouldBeFound)
{
    EXPECT_FALSE(fallsWithTheSquare([](double r) { return 4.0 / r; }));
}

TEST(Light, APointLightLiesWhereItStands)
{
    EXPECT_EQ(arrivalAt(pointAt({1, 1, 5}), {1, 1, 2}).L, Vec3d(0, 0, 1));
    EXPECT_EQ(arrivalAt(pointAt({0, 1e200, 0}), {}).L, Vec3d(0, 1, 0));
}

TEST(Light, H40_AtItsOwnPositionALightAddsNothing)
{
    const Arrival arrival = arrivalAt(pointAt({1, 2, 3}), {1, 2, 3});
    EXPECT_EQ(arrival.L, Vec3d());
    EXPECT_EQ(arrival.I, Vec3d());
}

TEST(Light, H40_VeryCloseItStopsGrowing)
{
    const double cap = 4.0 / (smallestLightDistance * smallestLightDistance);
    for (const double r : {1e-6, 1e-7, 1e-20, 1e-200, 5e-324}) {
        const Arrival arrival = arrivalAt(pointAt({r, 0, 0}), {});
        EXPECT_EQ(arrival.L, Vec3d(1, 0, 0)) << r;
        EXPECT_EQ(arrival.I.x, cap) << r;
        EXPECT_TRUE(std::isfinite(static_cast<float>(arrival.I.x))) << r;
    }
}

TEST(Light, H41_FromFarAPointLightActsAsADirectionalOne)
{
    const Vec3d towards = normalized(Vec3d{1, 2, 3});
    const Light sun = directional(towards);
    for (const double distance : {1e3, 1e6, 1e9, 1e12, 1e15}) {
        const Light lamp = pointAt(distance * towards, distance * distance * sun.intensity);
        const Vec3d point{0.3, -0.9, 0.3}; // |point| < 1: inside the object's bounding sphere
        const Arrival near = arrivalAt(lamp, point);
        ASSERT_TRUE(isFinite(near.I));
        // Parallax of at most 1/D, plus the rounding of the position and of the unit vector.
        EXPECT_LE(length(near.L - towards), 1.0 / distance + 4 * eps);
        EXPECT_LE(length(near.I - sun.intensity),
                  length(sun.intensity) * (2.0 / distance + 4e-6 / distance + 16 * eps));
    }
}

TEST(Light, BeyondTheRangeOfNumbersItIsDarkAndNotNaN)
{
    const Arrival arrival = arrivalAt(pointAt({1e300, 0, 0}), {});
    EXPECT_EQ(arrival.L, Vec3d(1, 0, 0));
    EXPECT_EQ(arrival.I, Vec3d());
}

TEST(Light, TheDiscIsTheSquaredChordOfItsAngularRadius)
{
    Light light;
    for (const auto& [degrees, disc] : {std::pair{0.0, 0.0}, {60.0, 1.0}, {90.0, 2.0}}) {
        light.angularRadius = degrees;
        // sin of a rounded angle: relative error of a few eps.
        EXPECT_NEAR(discOf(light), disc, 4 * eps);
    }
}

} // namespace
} // namespace reflectance
