#include "app/explorer/ui/light_angles.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

TEST(LightAngles, NameTheAxes)
{
    EXPECT_DOUBLE_EQ(anglesOf({0, 0, 1}).azimuth, 0.0);
    EXPECT_DOUBLE_EQ(anglesOf({1, 0, 0}).azimuth, 90.0);
    EXPECT_DOUBLE_EQ(anglesOf({0, 3, 0}).elevation, 90.0);
    EXPECT_DOUBLE_EQ(anglesOf({0, 3, 0}).distance, 3.0);
    EXPECT_DOUBLE_EQ(anglesOf({0, -1, 1}).elevation, -45.0);
}

TEST(LightAngles, GoThereAndBack)
{
    for (const Vec3d& v : {Vec3d(0.3, -0.4, 0.5), Vec3d(-2, 1, -1), Vec3d(1e-3, 5, 2e-3)}) {
        const Vec3d back = vectorOf(anglesOf(v));
        // Two conversions through degrees: a few roundings of numbers below 10.
        EXPECT_NEAR(length(back - v), 0.0, 1e-14 * length(v));
    }
}

TEST(LightAngles, AzimuthOutlivesTheZenith)
{
    // A light dragged to the zenith and back comes down where it went up.
    const Vec3d top = vectorOf({72.5, 90.0, 1.0});
    EXPECT_NEAR(anglesOf(top).azimuth, 72.5, 1e-9);
    EXPECT_DOUBLE_EQ(anglesOf(top).elevation, 90.0);
}

TEST(LightAngles, OneComponentLeavesTheRatioOfTheOthers)
{
    const Vec3d unit = normalized(Vec3d(0.2, 0.6, 0.3));
    const Vec3d edited = withComponent(unit, 0, 0.5);
    EXPECT_EQ(edited.x, 0.5);
    EXPECT_NEAR(edited.y / edited.z, 2.0, 1e-14); // a few roundings
    EXPECT_NEAR(length(edited), 1.0, 1e-15);
}

TEST(LightAngles, TheOthersComeBackWhenOneLeavesTheEndOfItsRange)
{
    const Vec3d unit = normalized(Vec3d(0.2, 0.6, 0.3));
    const Vec3d there = withComponent(unit, 1, 1.0);
    EXPECT_NEAR(length(there), 1.0, 1e-15);
    const Vec3d back = withComponent(there, 1, unit.y);
    EXPECT_NEAR(length(back - unit), 0.0, 1e-14); // a few roundings
    EXPECT_NEAR(length(withComponent({0, 1, 0}, 1, 0.6)), 1.0, 1e-15) << "from the axis itself";
}

TEST(LightAngles, SplitIntensityIntoStrengthAndTint)
{
    EXPECT_EQ(strengthOf({0.5, 2.0, 1.0}), 2.0);
    EXPECT_EQ(tintOf({0.5, 2.0, 1.0}), Vec3d(0.25, 1.0, 0.5));
    EXPECT_EQ(tintOf({0, 0, 0}), Vec3d(1.0));
}

} // namespace
} // namespace reflectance::explorer
