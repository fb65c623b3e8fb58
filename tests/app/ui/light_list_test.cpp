// Adding and removing lights: selection and solo stay with the lights they were on.
#include "app/explorer/ui/light_list.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <set>

namespace reflectance::explorer {
namespace {

ExplorerState withLights(int count)
{
    ExplorerState state;
    for (int i = 0; i < count; ++i) {
        Light light;
        light.name = std::string(1, static_cast<char>('a' + i));
        state.scene.lights.push_back(light);
    }
    return state;
}

TEST(LightList, GivesSixtyFourLightsNamesAndPlacesOfTheirOwn)
{
    ExplorerState state;
    std::set<std::string> names;
    for (int i = 0; i < 64; ++i)
        addLight(state, i % 2 == 0 ? LightKind::Directional : LightKind::Point);
    for (const Light& light : state.scene.lights)
        names.insert(light.name);
    EXPECT_EQ(names.size(), 64U);
    EXPECT_EQ(state.selectedLight, 63);
    for (std::size_t i = 1; i < 64; ++i)
        EXPECT_FALSE(state.scene.lights[i].direction == state.scene.lights[i - 1].direction);
}

TEST(LightList, RemovingOneAboveMovesSelectionAndSoloAlong)
{
    ExplorerState state = withLights(4);
    state.selectedLight = 2;
    state.soloLight = 3;
    removeLight(state, 0);
    EXPECT_EQ(state.scene.lights[static_cast<std::size_t>(state.selectedLight)].name, "c");
    EXPECT_EQ(state.scene.lights[static_cast<std::size_t>(state.soloLight)].name, "d");
}

TEST(LightList, RemovingOneBelowLeavesThem)
{
    ExplorerState state = withLights(3);
    state.selectedLight = 0;
    state.soloLight = 1;
    removeLight(state, 2);
    EXPECT_EQ(state.selectedLight, 0);
    EXPECT_EQ(state.soloLight, 1);
}

TEST(LightList, RemovingTheSoloLightLetsAllShine)
{
    ExplorerState state = withLights(2);
    state.soloLight = 1;
    removeLight(state, 1);
    EXPECT_EQ(state.soloLight, -1);
    EXPECT_EQ(state.selectedLight, 0);
}

TEST(LightList, RemovingTheLastOneSelectsNone)
{
    ExplorerState state = withLights(1);
    removeLight(state, 0);
    EXPECT_TRUE(state.scene.lights.empty());
    EXPECT_EQ(state.selectedLight, -1);
}

TEST(LightList, SwatchShowsTheTintAsTheScreenWould)
{
    Light light;
    light.intensity = {2.0, 2.0 * 0.2158605, 0.0}; // 0.2158605 is the linear value of sRGB code 128
    EXPECT_EQ(swatchColor(light), IM_COL32(255, 128, 0, 255));
}

} // namespace
} // namespace reflectance::explorer
