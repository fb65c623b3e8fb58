// Directions to angles and back, in all three systems.
#include "core/measured/angles.h"

#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;
constexpr AngleSystem everySystem[] = {AngleSystem::Polar, AngleSystem::Isotropic, AngleSystem::HalfDifference,
                                       AngleSystem::Specular};

Vec3d anyAbove(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    return directionAt(std::acos(unit(random)), 2.0 * pi * unit(random));
}

TEST(Angles, ComeBackFromTheDirectionsThatTheyName)
{
    std::mt19937_64 random(7);
    for (const AngleSystem system : everySystem)
        for (int i = 0; i < 1000; ++i) {
            const Angles at = anglesOf(system, anyAbove(random), anyAbove(random));
            const DirectionPair pair = directionsAt(system, at);
            const Angles again = anglesOf(system, pair.L, pair.V);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // A dozen roundings of unit vectors, divided by the sine of the polar angle where an azimuth is meant; no
                // random direction comes nearer to a pole than 0.01. phi_d = 0 and pi are one and the same.
                double apart = std::fabs(again[axis] - at[axis]);
                if (axis == 2)
                    apart = std::min(apart, pi - std::fmod(apart, pi));
                EXPECT_LT(apart, 1e-12) << nameOf(system) << ' ' << axis;
            }
        }
}

/// By hand: L at 30 degrees towards +x, V at 50 towards -x.
TEST(Angles, OfThePlaneOfIncidence)
{
    const Vec3d L = directionAt(pi / 6.0, 0.0);
    const Vec3d V = directionAt(5.0 * pi / 18.0, pi);
    const Angles isotropic = anglesOf(AngleSystem::Isotropic, L, V);
    EXPECT_NEAR(isotropic[0], pi / 6.0, 1e-15);
    EXPECT_NEAR(isotropic[1], 5.0 * pi / 18.0, 1e-15);
    EXPECT_NEAR(isotropic[2], pi, 1e-15);
    const Angles half = anglesOf(AngleSystem::HalfDifference, L, V);
    EXPECT_NEAR(half[0], pi / 18.0, 1e-15); // the half vector leans 10 degrees to V
    EXPECT_NEAR(half[1], 2.0 * pi / 9.0, 1e-15);
    EXPECT_NEAR(std::sin(half[2]), 0.0, 1e-15); // 0 or pi, which are the same
    const Angles specular = anglesOf(AngleSystem::Specular, L, V);
    EXPECT_NEAR(specular[1], pi / 9.0, 1e-15); // 20 degrees beyond the mirror direction, away from N
    EXPECT_NEAR(std::fabs(specular[2]), pi, 1e-15);
    EXPECT_NEAR(anglesOf(AngleSystem::Specular, L, directionAt(0.1, pi))[2], 0.0, 1e-15) << "towards N";
}

TEST(Angles, AreReciprocalAndIsotropicInHalfAndDifference)
{
    std::mt19937_64 random(8);
    for (int i = 0; i < 1000; ++i) {
        const Vec3d L = anyAbove(random);
        const Vec3d V = anyAbove(random);
        const Angles one = anglesOf(AngleSystem::HalfDifference, L, V);
        const Angles other = anglesOf(AngleSystem::HalfDifference, V, L);
        EXPECT_NEAR(one[0], other[0], 1e-13);
        EXPECT_NEAR(one[1], other[1], 1e-13);
        EXPECT_NEAR(std::sin(one[2] - other[2]), 0.0, 1e-12);
        const auto turned = [](const Vec3d& v) { return Vec3d{0.6 * v.x - 0.8 * v.y, 0.8 * v.x + 0.6 * v.y, v.z}; };
        const Angles elsewhere = anglesOf(AngleSystem::HalfDifference, turned(L), turned(V));
        EXPECT_NEAR(std::sin(one[2] - elsewhere[2]), 0.0, 1e-12);
    }
}

/// At the poles and at equal or opposite directions nothing is undefined.
TEST(Angles, AreFiniteAtThePoles)
{
    const Vec3d N{0, 0, 1};
    const Vec3d X{1, 0, 0};
    for (const AngleSystem system : everySystem)
        for (const Vec3d& L : {N, X, -X})
            for (const Vec3d& V : {N, X, -X})
                for (const double angle : anglesOf(system, L, V))
                    EXPECT_TRUE(std::isfinite(angle)) << nameOf(system);
    EXPECT_EQ(anglesOf(AngleSystem::HalfDifference, N, N), Angles());
}

} // namespace
} // namespace reflectance
