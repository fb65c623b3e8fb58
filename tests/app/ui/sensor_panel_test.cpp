// The sensor's parts, all of them open: looking changes nothing, every control has its own identity and a tooltip.
#include "app/explorer/ui/sensor_parts.h"
#include "core/sensor/fields.h"
#include "tests/app/ui/sweep.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

const ImVec2 corner{0.0F, 0.0F};
const ImVec2 size{360.0F, 1200.0F};

ExplorerState withEveryPart()
{
    ExplorerState state;
    state.scene = defaultScene();
    Sensor& sensor = state.scene.sensor;
    for (const char* part : {"camera=on:shutter=0.0123456789", "vignetting=polynomial", "noise=3.3333333",
                             "balance=1.23456789,1,2", "response=gamma:gamma=2.345678", "quantisation=13"})
        EXPECT_TRUE(setOnSensor(part, sensor)) << part;
    return state;
}

void draw(ExplorerState& state)
{
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize(size);
    ImGui::Begin("sensor", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    drawSensorParts(state);
    ImGui::End();
}

TEST(SensorPanel, GivesEveryControlAnIdentityAndATooltipAndLooksWithoutTouching)
{
    Stage stage(size.x, size.y);
    ExplorerState state = withEveryPart();
    const Sensor before = state.scene.sensor;
    const Faults faults = sweep(stage, corner, size, {18.0F, 10.0F}, [&] { draw(state); });
    EXPECT_TRUE(faults.shared.empty()) << faults.shared.size();
    EXPECT_TRUE(faults.silent.empty()) << faults.silent.size();
    EXPECT_GT(faults.controls, 35U); // 9 switches, 8 solos, 22 fields and choices, more
    EXPECT_EQ(state.scene.sensor, before);
    EXPECT_FALSE(state.message);
}

TEST(SensorPanel, SaysWhatDiffersFromTheDefault)
{
    EXPECT_EQ(sensorPartsSummary(Sensor()), "");
    EXPECT_EQ(sensorPartsSummary(withEveryPart().scene.sensor), "camera, vignetting, noise, balance, response, 13 bit");
    Sensor sensor;
    ASSERT_TRUE(setOnSensor("all=off", sensor));
    EXPECT_EQ(sensorPartsSummary(sensor), "not exposed, well, linear, not quantised");
}

TEST(SensorPanel, APartAloneIsWhatIsDrawnAndTheSceneKeepsTheRest)
{
    ExplorerState state = withEveryPart();
    state.soloPart = "noise";
    const Sensor shown = shownScene(state).sensor;
    EXPECT_TRUE(shown.noise.on);
    EXPECT_FALSE(shown.camera.on || shown.vignetting.on || shown.quantisation.on);
    EXPECT_TRUE(state.scene.sensor.camera.on);
    Stage stage(size.x, size.y);
    state.scene.sensor.noise.on = false; // switched off, it cannot be alone
    stage.frame([&] { draw(state); });
    EXPECT_EQ(state.soloPart, "");
}

} // namespace
} // namespace reflectance::explorer
