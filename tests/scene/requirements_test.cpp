// What a scene requires, and what is said of the rest.
#include "core/scene/requirements.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(Requirements, NameOnlyWhatTheSceneNeeds)
{
    Scene scene = defaultScene();
    EXPECT_EQ(requirementsOf(scene).key(), "hybrid+one+directional");
    scene.lights.front().kind = LightKind::Point;
    EXPECT_EQ(requirementsOf(scene).key(), "hybrid+one+directional+point");
    scene.lights.clear();
    EXPECT_EQ(requirementsOf(scene).key(), "hybrid+one");
    scene.surface.model = "mirror";
    EXPECT_EQ(requirementsOf(scene).key(), "mirror+environment");
    scene.environment.radiance = {};
    scene.background.kind = BackgroundKind::Environment;
    EXPECT_EQ(requirementsOf(scene).key(), "mirror");
}

TEST(Requirements, LightsThatGiveNothingAreNotRequired)
{
    Scene scene = defaultScene();
    scene.lights[0].on = false;
    scene.lights[1].intensity = {};
    EXPECT_FALSE(requirementsOf(scene).directionalLights);
    scene.lights[0].on = true; // the planted opposite: one light that shines is enough
    EXPECT_TRUE(requirementsOf(scene).directionalLights);
}

TEST(LeftOut, SaysWhyAMirrorShowsNothingOfALightWithoutExtent)
{
    Scene scene = defaultScene();
    scene.surface.model = "mirror";
    EXPECT_THAT(leftOut(scene), Not(Contains(HasSubstr("radius is 0"))));
    scene.lights[0].angularRadius = 0.0;
    EXPECT_THAT(leftOut(scene), Contains(HasSubstr("light 'key': its radius is 0")));
}

TEST(LeftOut, SaysThatAModelIgnoresTheEnvironment)
{
    Scene scene = defaultScene();
    EXPECT_THAT(leftOut(scene), Contains(HasSubstr("environment: ")));
    scene.environment.kind = EnvironmentKind::None;
    EXPECT_THAT(leftOut(scene), Not(Contains(HasSubstr("environment: "))));
}

} // namespace
} // namespace reflectance
