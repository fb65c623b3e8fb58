// All panels for every model, drawn into nothing: untouched values stay, every control has its own identity
// and a tooltip.
#include "app/explorer/ui/ui.h"
#include "tests/app/ui/sweep.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

const ImVec2 place{0.0F, 0.0F};
const ImVec2 size{360.0F, 1300.0F}; // tall enough that nothing scrolls

ExplorerState stateFor(const Model& model)
{
    ExplorerState state;
    state.scene = defaultScene();
    state.scene.surface.model = model.id();
    state.sensorCounts = SensorCounts{1, 2, 3};
    return state;
}

void drawIn(ImVec2 windowSize, const Stage::Draw& draw)
{
    ImGui::SetNextWindowPos(place);
    ImGui::SetNextWindowSize(windowSize);
    ImGui::Begin("panels", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    draw();
    ImGui::End();
}

void expectSameScene(const Scene& a, const Scene& b)
{
    EXPECT_EQ(a.lights, b.lights);
    EXPECT_EQ(a.environment, b.environment);
    EXPECT_EQ(a.background, b.background);
    EXPECT_EQ(a.surface, b.surface);
    EXPECT_EQ(a.sensor, b.sensor);
    EXPECT_EQ(a.camera, b.camera);
}

std::string pointsOf(const std::vector<ImVec2>& points)
{
    std::string text;
    for (const ImVec2 p : points)
        text += " (" + std::to_string(static_cast<int>(p.x)) + ", " + std::to_string(static_cast<int>(p.y)) + ")";
    return text;
}

class EveryModel : public testing::TestWithParam<std::size_t> {
protected:
    ExplorerState state = stateFor(catalogue()[GetParam()]);
};

TEST_P(EveryModel, LooksWithoutTouching)
{
    Stage stage(360.0F, 1300.0F);
    // Values that a careless control would round or clamp: more digits than are shown, beyond the slider.
    state.scene.surface.values = {
        {"ks", {0.123456789}}, {"kd", {1.7}}, {"n", {123456.789}}, {"reflectance", {1.0 / 3.0}}};
    state.scene.lights[0].intensity = Vec3d(1.0 / 3.0, 200.0, 0.0);
    state.scene.sensor.exposure = 12.3456789;
    const Scene before = state.scene;
    // The mouse crosses everything; nothing is pressed.
    for (int step = 0; step < 130; ++step) {
        stage.moveTo({10.0F + 2.6F * static_cast<float>(step), 10.0F * static_cast<float>(step)});
        stage.frame([&] { drawIn(size, [&] { drawPanels(state); }); });
    }
    expectSameScene(before, state.scene);
    EXPECT_FALSE(state.message);
    EXPECT_TRUE(state.requests.empty());
}

TEST_P(EveryModel, TabbingThroughChangesNothing)
{
    Stage stage(360.0F, 1300.0F);
    state.scene.surface.values = {{"ks", {0.123456789}}, {"n", {123456.789}}};
    const Scene before = state.scene;
    const auto draw = [&] { drawIn(size, [&] { drawPanels(state); }); };
    stage.frame(draw);
    ImGui::SetWindowFocus("panels");
    for (int step = 0; step < 60; ++step)
        stage.press(ImGuiKey_Tab, draw);
    expectSameScene(before, state.scene);
}

TEST_P(EveryModel, GivesEveryControlAnIdentityAndATooltip)
{
    Stage stage(360.0F, 1300.0F);
    const auto draw = [&] { drawIn(size, [&] { drawPanels(state); }); };
    // 18 x 10 pixels: the smallest control, the button that removes a light, is 22 x 22.
    const Faults faults = sweep(stage, place, size, {18.0F, 10.0F}, draw);
    EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity at" << pointsOf(faults.shared);
    EXPECT_TRUE(faults.silent.empty()) << "no tooltip at" << pointsOf(faults.silent);
    EXPECT_GT(faults.controls, 20U);
}

std::string nameOfModel(const testing::TestParamInfo<std::size_t>& model)
{
    return catalogue()[model.param].id();
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryModel, testing::Range<std::size_t>(0, catalogue().size()), nameOfModel);

TEST(Bars, GiveEveryButtonAnIdentityAndATooltip)
{
    Stage stage(1280.0F, 44.0F);
    ExplorerState state = stateFor(catalogue().front());
    const auto draw = [&] { drawIn({1280.0F, 44.0F}, [&] { drawToolbar(state); }); };
    const Faults faults = sweep(stage, place, {1280.0F, 44.0F}, {12.0F, 10.0F}, draw);
    EXPECT_TRUE(faults.shared.empty()) << pointsOf(faults.shared);
    EXPECT_TRUE(faults.silent.empty()) << pointsOf(faults.silent);
    EXPECT_EQ(faults.controls, 14U) << "one of the buttons is not in the window";
}

TEST(Bars, DrawMessagesAndLoadingAndHelpTogether)
{
    Stage stage;
    ExplorerState state = stateFor(catalogue().front());
    state.message = Message{"this file cannot be read", true};
    state.loading = Loading{"/meshes/bunny.obj", 0.4};
    state.showHelp = state.showFileBrowser = true;
    const auto draw = [&] {
        drawIn({1280.0F, 26.0F}, [&] { drawStatusLine(state); });
        drawHelp(state);
        drawFileBrowser(state);
    };
    for (int i = 0; i < 5; ++i)
        stage.frame(draw);
    EXPECT_TRUE(state.showHelp && state.showFileBrowser && state.message);
}

TEST(Bars, KeepMessagesOutOfThePictureOfAPlot)
{
    const auto windows = [](bool hasMessage, bool takingPicture) {
        Stage stage;
        ExplorerState state = stateFor(catalogue().front());
        if (hasMessage)
            state.message = Message{"Saved: plot.png", false};
        state.takingPicture = takingPicture;
        for (int i = 0; i < 3; ++i)
            stage.frame([&] { drawIn({1280.0F, 26.0F}, [&] { drawStatusLine(state); }); });
        return ImGui::GetIO().MetricsActiveWindows;
    };
    EXPECT_EQ(windows(true, true), windows(false, false));
    EXPECT_GT(windows(true, false), windows(false, false)) << "the planted fault";
}

/// The middle of the first control that the mouse meets, row by row; {0, 0} where there is none.
ImVec2 firstControl(Stage& stage, ImVec2 from, ImVec2 to, const Stage::Draw& draw)
{
    for (float y = from.y; y < to.y; y += 6.0F)
        for (float x = from.x; x < to.x; x += 6.0F) {
            stage.moveTo({x, y});
            stage.frame(draw);
            if (Stage::hovered() != 0)
                return {x + 6.0F, y + 6.0F};
        }
    return {};
}

TEST(Bars, OfferAnEarlierSessionBelowAMessage)
{
    Stage stage;
    ExplorerState state = stateFor(catalogue().front());
    state.earlierSessions = {{"s.json", "mug, hybrid, 2 lights", "5 minutes ago", false}};
    const auto draw = [&] {
        ImGui::SetNextWindowPos({0.0F, 774.0F});
        ImGui::SetNextWindowSize({1280.0F, 26.0F});
        ImGui::Begin("status", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawStatusLine(state);
        ImGui::End();
    };
    stage.frame(draw);
    stage.frame(draw);
    stage.click(firstControl(stage, {20.0F, 640.0F}, {200.0F, 770.0F}, draw), draw);
    ASSERT_EQ(state.requests.size(), 1U);
    EXPECT_EQ(state.requests[0].kind, Request::Kind::OpenFile);
    EXPECT_EQ(state.requests[0].path, "s.json");
    state.earlierSessions[0].dismissed = true;
    stage.frame(draw);
    EXPECT_EQ(firstControl(stage, {20.0F, 640.0F}, {200.0F, 770.0F}, draw).x, 0.0F) << "planted: nothing to press";
}

TEST(Panels, TakeSixtyFourLightsAndNone)
{
    Stage stage(360.0F, 800.0F);
    ExplorerState state = stateFor(catalogue().front());
    const auto draw = [&] { drawIn({360.0F, 800.0F}, [&] { drawPanels(state); }); };
    state.scene.lights.assign(64, Light{});
    state.selectedLight = 63;
    stage.frame(draw);
    stage.frame(draw);
    EXPECT_EQ(state.scene.lights.size(), 64U);
    state.scene.lights.clear();
    state.selectedLight = -1;
    stage.frame(draw);
    stage.frame(draw);
    EXPECT_TRUE(state.scene.lights.empty());
}

// The sweep itself must find what it looks for.
TEST(Sweep, FindsPlantedFaults)
{
    Stage stage(300.0F, 200.0F);
    const auto planted = [] {
        drawIn({300.0F, 200.0F}, [] {
            ImGui::Button("same", {100, 30});
            ImGui::Button("other", {100, 30});
            ImGui::Button("same", {100, 30});
        });
    };
    const Faults faults = sweep(stage, place, {300.0F, 200.0F}, {18.0F, 10.0F}, planted);
    EXPECT_EQ(faults.shared.size(), 1U);
    EXPECT_EQ(faults.silent.size(), 2U);
    EXPECT_EQ(faults.controls, 2U);
}

} // namespace
} // namespace reflectance::explorer
