#include "core/math/angle.h"
#include "core/math/vec.h"

#include <gtest/gtest.h>
#include <limits>

namespace reflectance {
namespace {

constexpr double eps = 0x1p-53;

TEST(Normalized, WorksForEveryLength)
{
    const double component = std::sqrt(0.5);
    for (const double length : {5e-324, 1e-310, 1e-200, 1e-100, 1.0, 1e100, 1e200, 1e308}) {
        const Vec3d unit = normalized({length, 0.0, -length});
        // One rounding each for the square root and the division.
        EXPECT_NEAR(unit.x, component, 2.0 * eps) << length;
        EXPECT_EQ(unit.z, -unit.x) << length;
    }
}

TEST(Normalized, DoesNotDependOnPowersOfTwo)
{
    const Vec3d v{0.3, -1.7, 0.09};
    const Vec3d unit = normalized(v);
    for (int exponent = -900; exponent <= 900; exponent += 25)
        EXPECT_EQ(normalized(std::ldexp(1.0, exponent) * v), unit) << exponent;
}

TEST(Normalized, GivesZeroWhereThereIsNoDirection)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Vec3d& v : {Vec3d(), Vec3d(nan, 0, 1), Vec3d(0, infinity, 0), Vec3d(1, -infinity, nan)})
        EXPECT_EQ(normalized(v), Vec3d());
}

TEST(Matrix, IsStoredRowByRow)
{
    const Mat3d K{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
    EXPECT_EQ(K * Vec3d(1, 0, 0), Vec3d(1, 4, 7));
    EXPECT_EQ(K * Vec3d(0, 0, 2), Vec3d(6, 12, 18));
}

TEST(Cross, FollowsTheRightHand)
{
    EXPECT_EQ(cross(Vec3d(1, 0, 0), Vec3d(0, 1, 0)), Vec3d(0, 0, 1));
}

TEST(SquaredChord, IsThatOfTheUnitCircle)
{
    EXPECT_EQ(squaredChord(0.0), 0.0);
    EXPECT_NEAR(squaredChord(60.0), 1.0, 4.0 * eps);
    EXPECT_NEAR(squaredChord(90.0), 2.0, 8.0 * eps);
    // A small angle keeps all its digits, where 2 - 2 cos would have lost them.
    EXPECT_NEAR(squaredChord(1e-6) / (radians(1e-6) * radians(1e-6)), 1.0, 8.0 * eps);
}

} // namespace
} // namespace reflectance
