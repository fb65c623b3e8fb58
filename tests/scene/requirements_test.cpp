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

TEST(Requirements, AskWhereSamplesLieOnlyForViewersAndLightsThatAreNear)
{
    Scene scene = defaultScene();
    scene.lights[1] = scene.lights[0]; // far away, both
    const auto asks = [&](const char* model) {
        scene.surface.model = model;
        return requirementsOf(scene).positions;
    };
    EXPECT_FALSE(asks("lambert"));
    EXPECT_FALSE(asks("lambert_color"));
    EXPECT_TRUE(asks("hybrid"));
    EXPECT_TRUE(asks("oren_nayar"));
    EXPECT_TRUE(asks("mirror"));
    EXPECT_TRUE(asks("table"));
    scene.surface.values["sigma"] = {0.0}; // Lambert, but black from behind
    EXPECT_TRUE(asks("oren_nayar"));
    scene.lights[1].kind = LightKind::Point;
    EXPECT_TRUE(asks("lambert"));
    scene.lights[1].on = false;
    EXPECT_FALSE(asks("lambert"));
    EXPECT_THAT(leftOut(scene), Contains(HasSubstr("where the samples lie")));
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
