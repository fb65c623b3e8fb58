// Each key does what the help page says.
#include "app/explorer/keys.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

ExplorerState stateWithLights(std::size_t count)
{
    ExplorerState state;
    state.scene.lights.resize(count);
    return state;
}

TEST(Keys, LeaveRequests)
{
    using Kind = Request::Kind;
    const std::pair<KeyPress, Kind> table[] = {
        {{"f"}, Kind::Frame},
        {{"r"}, Kind::ResetView},
        {{"F12"}, Kind::SaveView},
        {{"F12", true}, Kind::SaveWindow},
        {{"o", true}, Kind::OpenDialog},
        {{"s", true}, Kind::SaveScene},
        {{"q", true}, Kind::Quit},
    };
    for (const auto& [key, kind] : table) {
        ExplorerState state = stateWithLights(1);
        press(key, state);
        ASSERT_EQ(state.requests.size(), 1U) << key.key;
        EXPECT_EQ(state.requests[0].kind, kind) << key.key;
    }
}

TEST(Keys, AnswerTheOfferOfAnEarlierSession)
{
    using Kind = Request::Kind;
    ExplorerState state = stateWithLights(1);
    press({"r", true}, state);
    press({"Esc"}, state);
    EXPECT_TRUE(state.requests.empty()) << "nothing is offered";
    state.earlierSessions = {{"1.json", "", "", true}, {"2.json", "", "", false}};
    state.message = Message{"on top", false};
    press({"r", true}, state);
    press({"Esc"}, state); // closes the message
    press({"Esc"}, state);
    ASSERT_EQ(state.requests.size(), 2U);
    EXPECT_EQ(state.requests[0].kind, Kind::OpenFile);
    EXPECT_EQ(state.requests[1].kind, Kind::Dismiss);
    for (const Request& request : state.requests)
        EXPECT_EQ(request.path, "2.json") << "the first is dismissed already";
}

TEST(Keys, ProbeAndPutTheProbeAway)
{
    ExplorerState state = stateWithLights(1);
    press({"p"}, state);
    EXPECT_TRUE(state.probe.asked);
    state.probe.loose = ProbePlace();
    state.probe.term = "diffuse";
    press({"Esc"}, state);
    EXPECT_TRUE(state.probe.term.empty());
    EXPECT_TRUE(state.probe.loose) << "one thing at a time";
    press({"Esc"}, state);
    EXPECT_FALSE(state.probe.loose);
    EXPECT_TRUE(state.requests.empty());
}

TEST(Keys, OpenPagesOfTheWorkbench)
{
    ExplorerState state = stateWithLights(1);
    press({"F2"}, state);
    press({"F9"}, state);
    press({"F10"}, state);
    press({"F11"}, state);
    press({"F12", true}, state);
    ASSERT_EQ(state.requests.size(), 5U);
    state.requests.pop_back(); // saves the window
    for (const Request& request : state.requests)
        EXPECT_EQ(request.kind, Request::Kind::TogglePage);
    EXPECT_EQ(state.requests[0].path, "0");
    EXPECT_EQ(state.requests[1].path, "7");
    EXPECT_EQ(state.requests[2].path, "8");
    EXPECT_EQ(state.requests[3].path, "9");
}

TEST(Keys, LayTheLensAndChangeIt)
{
    ExplorerState state = stateWithLights(1);
    press({"l", false, true}, state);
    EXPECT_FALSE(state.lens) << "there is none to change";
    press({"l"}, state);
    EXPECT_EQ(state.lens, LensKind::Float);
    for (const LensKind next : {LensKind::Half, LensKind::Simd, LensKind::Glsl, LensKind::Float}) {
        press({"l", false, true}, state);
        EXPECT_EQ(state.lens, next);
    }
    press({"l"}, state);
    EXPECT_FALSE(state.lens);
}

TEST(Keys, SwitchAndSwitchBack)
{
    ExplorerState state = stateWithLights(1);
    press({"t"}, state);
    press({"h"}, state);
    press({"F1"}, state);
    EXPECT_TRUE(state.turntable);
    EXPECT_FALSE(state.preferences.showLightHandles);
    EXPECT_TRUE(state.showHelp);
    press({"t"}, state);
    press({"h"}, state);
    EXPECT_FALSE(state.turntable);
    EXPECT_TRUE(state.preferences.showLightHandles);
}

TEST(Keys, StepThroughEveryModelBothWays)
{
    ExplorerState state = stateWithLights(1);
    const std::string start = state.scene.surface.model;
    std::vector<std::string> met;
    for (std::size_t i = 0; i < catalogue().size(); ++i) {
        press({"m"}, state);
        met.push_back(state.scene.surface.model);
    }
    EXPECT_EQ(state.scene.surface.model, start);
    std::vector<std::string> all;
    for (const Model& model : catalogue())
        all.push_back(model.id());
    EXPECT_THAT(met, testing::UnorderedElementsAreArray(all));
    press({"m"}, state);
    press({"m", false, true}, state);
    EXPECT_EQ(state.scene.surface.model, start);
}

TEST(Keys, SelectOnlyLightsThatAreThere)
{
    ExplorerState state = stateWithLights(3);
    press({"3"}, state);
    EXPECT_EQ(state.selectedLight, 2);
    press({"4"}, state);
    EXPECT_EQ(state.selectedLight, 2);
}

TEST(Keys, EscapeClosesWhatLiesOnTop)
{
    ExplorerState state = stateWithLights(1);
    state.showHelp = true;
    state.loading = Loading{"bunny.obj", 0.5};
    state.message = Message{"sentence", true};
    press({"Esc"}, state);
    EXPECT_FALSE(state.showHelp);
    EXPECT_TRUE(state.requests.empty());
    press({"Esc"}, state);
    ASSERT_EQ(state.requests.size(), 1U);
    EXPECT_EQ(state.requests[0].kind, Request::Kind::CancelLoading);
    state.loading.reset();
    press({"Esc"}, state);
    EXPECT_FALSE(state.message);
}

TEST(Keys, LeaveTheSceneAloneWhileAFileIsChosen)
{
    ExplorerState state = stateWithLights(2);
    state.showFileBrowser = true;
    const std::string model = state.scene.surface.model;
    for (const char* key : {"m", "2", "t"})
        press({key}, state);
    EXPECT_EQ(state.scene.surface.model, model);
    EXPECT_EQ(state.selectedLight, 0);
    EXPECT_FALSE(state.turntable);
    press({"Esc"}, state);
    EXPECT_FALSE(state.showFileBrowser);
}

TEST(Keys, WithoutMeaningChangeNothing)
{
    ExplorerState state = stateWithLights(2);
    for (const KeyPress& key : {KeyPress{"z"}, KeyPress{"f", true}, KeyPress{""}, KeyPress{"0"}, KeyPress{"\xC3\xB6"}})
        press(key, state);
    EXPECT_TRUE(state.requests.empty());
    EXPECT_EQ(state.selectedLight, 0);
    press({"2"}, state); // planted: a key that has a meaning must show in the same checks
    EXPECT_NE(state.selectedLight, 0);
}

} // namespace
} // namespace reflectance::explorer
