// Undo and redo: what was done comes back bit for bit, a stroke of the hand is one step, and what is held is bounded.
#include "app/explorer/history.h"

#include "app/explorer/comparison.h"
#include "app/explorer/keys.h"
#include "app/explorer/state.h"
#include "core/scene/scene_file.h"
#include "core/scene/variants.h"

#include <gmock/gmock.h>
#include <random>

namespace reflectance::explorer {
namespace {

using std::chrono::milliseconds;

struct Desk {
    ExplorerState state;
    Scene start = defaultScene();
    History::Time now{};

    Desk()
    {
        state.scene = start;
        frame();
    }
    void frame(Hand hand = {})
    {
        now += milliseconds(16);
        state.history.watch(state, hand, now);
    }
    [[nodiscard]] std::size_t steps() const { return state.history.steps().size(); }
};

/// Everything that a scene file says, and what else a step holds.
std::string everythingOf(const ExplorerState& state)
{
    return sceneText(state.scene, "") + (state.compare.on ? " compared" : "") +
           (state.compare.beforeClay ? " clay" : "");
}

/// One edit of those that panels, gestures and keys make.
void edit(ExplorerState& state, std::mt19937_64& random)
{
    const auto number = [&] { return std::uniform_real_distribution<double>(0.01, 3.0)(random); };
    Scene& scene = state.scene;
    Surface& hand = surfaceInHand(state.compare, scene);
    switch (random() % 12) {
    case 0:
        hand.values["n"] = {number()};
        break;
    case 1:
        hand.values["K"] = {number(), 0, 0, 0, number(), 0, 0, 0, number()};
        break;
    case 2:
        press({"m", false, random() % 2 == 0}, state);
        break;
    case 3:
        scene.camera.eye = {number(), number(), number()};
        break;
    case 4:
        scene.lights.emplace_back().name = "light " + std::to_string(random() % 1000);
        break;
    case 5:
        if (!scene.lights.empty())
            scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(random() % scene.lights.size()));
        break;
    case 6:
        for (Light& light : scene.lights)
            light.direction = {number(), -number(), number()};
        break;
    case 7:
        scene.sensor.exposure = number();
        break;
    case 8:
        scene.environment.rotation = 100.0 * number();
        break;
    case 9:
        press({"c"}, state);
        break;
    case 10:
        press({"b"}, state);
        break;
    default:
        press({"x"}, state);
        swapVariants(scene);
    }
}

TEST(History, UndoAllIsTheIdentityAndRedoAllTheEndBitForBit)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Desk desk;
        std::mt19937_64 random(seed);
        std::vector<std::string> states{everythingOf(desk.state)};
        for (int i = 0; i < 100; ++i) {
            edit(desk.state, random);
            desk.frame();
            if (everythingOf(desk.state) != states.back())
                states.push_back(everythingOf(desk.state));
        }
        const Scene end = desk.state.scene;
        ASSERT_EQ(desk.steps(), states.size()) << "every change is one step, and nothing else is";
        for (std::size_t i = states.size() - 1; i-- > 0;) {
            desk.state.history.undo(desk.state);
            desk.frame(); // coming back is no change of its own
            ASSERT_EQ(everythingOf(desk.state), states[i]) << "seed " << seed << ", step " << i;
        }
        EXPECT_FALSE(desk.state.history.canUndo());
        for (std::size_t i = 1; i < states.size(); ++i) {
            desk.state.history.redo(desk.state);
            ASSERT_EQ(everythingOf(desk.state), states[i]) << "seed " << seed << ", step " << i;
        }
        EXPECT_TRUE(desk.state.scene == end);
        EXPECT_FALSE(desk.state.history.canRedo());
    }
}

TEST(History, ALastBitIsAChange) // planted: what the test above would not see if it compared rounded numbers
{
    Desk desk;
    desk.state.scene.sensor.exposure = std::nextafter(desk.state.scene.sensor.exposure, 1.0);
    desk.frame();
    EXPECT_EQ(desk.steps(), 2U);
}

TEST(History, ADragIsOneStep)
{
    Desk desk;
    for (int i = 1; i <= 50; ++i) {
        desk.state.scene.surface.values["n"] = {40.0 + i};
        desk.frame({.busy = true});
    }
    EXPECT_EQ(desk.steps(), 1U) << "the hand still holds it";
    desk.frame();
    ASSERT_EQ(desk.steps(), 2U);
    EXPECT_EQ(desk.state.history.undoName(), "Phong exponent");
    desk.state.history.undo(desk.state);
    EXPECT_TRUE(desk.state.scene == desk.start);
}

TEST(History, AStrokeThatComesBackIsNoStep)
{
    Desk desk;
    const Vec3d start = desk.state.scene.lights[0].direction;
    desk.state.scene.lights[0].direction = {1, 0, 0};
    desk.frame({.busy = true});
    desk.state.scene.lights[0].direction = start;
    desk.frame();
    EXPECT_EQ(desk.steps(), 1U);
}

TEST(History, TurnsOfTheWheelAreOneStepUntilThePause)
{
    Desk desk;
    const auto zoom = [&] {
        Camera& camera = desk.state.scene.camera;
        camera.eye = camera.target + 0.9 * (camera.eye - camera.target);
        desk.frame();
    };
    for (int i = 0; i < 5; ++i)
        zoom();
    EXPECT_EQ(desk.steps(), 2U);
    EXPECT_EQ(desk.state.history.undoName(), "Zoom");
    desk.now += History::zoomPause;
    zoom();
    EXPECT_EQ(desk.steps(), 3U);
}

TEST(History, TheTurntableIsOneStepAndOtherChangesMeanwhileAreTheirOwn)
{
    Desk desk;
    for (int i = 1; i < 10; ++i) {
        desk.state.scene.camera.eye = {0.1 * i, 1, 3};
        desk.frame({.turning = true});
    }
    EXPECT_EQ(desk.steps(), 1U);
    desk.state.scene.sensor.exposure = 1.0;
    desk.frame({.turning = true});
    EXPECT_EQ(desk.steps(), 2U);
}

TEST(History, AChangeAfterUndoEndsTheOtherFuture)
{
    Desk desk;
    for (const double exposure : {1.0, 2.0, 3.0}) {
        desk.state.scene.sensor.exposure = exposure;
        desk.frame();
    }
    desk.state.history.go(1, desk.state);
    EXPECT_EQ(desk.state.scene.sensor.exposure, 1.0);
    desk.state.scene.lights.clear();
    desk.frame();
    EXPECT_FALSE(desk.state.history.canRedo());
    EXPECT_EQ(desk.steps(), 3U);
    EXPECT_EQ(desk.state.history.undoName(), "Remove a light");
}

TEST(History, WhatWasNotWholeIsNotLost)
{
    Desk desk;
    desk.state.scene.sensor.exposure = 1.0;
    desk.frame({.busy = true});
    desk.state.history.undo(desk.state); // before the frame that would have seen the hand leave
    EXPECT_EQ(desk.state.scene.sensor.exposure, 0.0);
    desk.state.history.redo(desk.state);
    EXPECT_EQ(desk.state.scene.sensor.exposure, 1.0);
}

TEST(History, HoldsNoMoreThanItSays)
{
    Desk desk;
    for (int i = 1; i <= 500; ++i) {
        desk.state.scene.sensor.exposure = i;
        desk.frame();
    }
    EXPECT_EQ(desk.steps(), History::mostSteps + 1);
    EXPECT_EQ(desk.state.history.here(), History::mostSteps);
    const std::size_t shared = desk.state.history.heldBytes();
    EXPECT_LT(shared, 100U << 20U) << "one mesh in all of them, counted once";
    desk.state.history.go(1000, desk.state); // not there
    EXPECT_EQ(desk.state.scene.sensor.exposure, 500.0);
}

TEST(History, OldStepsGoWhereMeshesTakeTooMuch)
{
    Desk desk;
    const std::size_t one = desk.state.history.heldBytes();
    desk.state.history = History(4 * one);
    desk.frame();
    for (int i = 1; i <= 12; ++i) {
        auto mesh = std::make_shared<Mesh>(*desk.state.scene.mesh);
        mesh->name = "scan " + std::to_string(i);
        desk.state.scene.mesh = mesh;
        desk.frame();
        EXPECT_LE(desk.state.history.heldBytes(), 4 * one);
    }
    EXPECT_EQ(desk.steps(), 4U);
    EXPECT_EQ(desk.state.history.undoName(), "Open scan 12");
}

TEST(History, NamesItsSteps)
{
    Desk desk;
    const auto nameAfter = [&](auto change) {
        change(desk.state);
        desk.frame();
        return desk.state.history.undoName();
    };
    using S = ExplorerState;
    EXPECT_EQ(nameAfter([](S& s) { s.scene.surface.model = "phong"; }),
              "Model " + modelOf(Surface{"phong", {}}).text.name);
    EXPECT_EQ(nameAfter([](S& s) { s.scene.lights[0].on = false; }), "Switch off " + desk.state.scene.lights[0].name);
    EXPECT_EQ(nameAfter([](S& s) {
                  s.scene.lights[0].direction = {1, 0, 0};
              }),
              "Move " + desk.state.scene.lights[0].name);
    EXPECT_EQ(nameAfter([](S& s) { s.scene.lights.emplace_back(); }), "Add a light");
    EXPECT_EQ(nameAfter([](S& s) { press({"c"}, s); }), "Compare");
    EXPECT_EQ(nameAfter([](S& s) { s.scene.other->model = "mirror"; }),
              "B: Model " + modelOf(Surface{"mirror", {}}).text.name);
    EXPECT_EQ(nameAfter([](S& s) { swapVariants(s.scene); }), "Swap A and B");
    EXPECT_EQ(nameAfter([](S& s) { press({"c"}, s); }), "End the comparison");
    EXPECT_EQ(nameAfter([](S& s) { press({"b"}, s); }), "Clay");
    EXPECT_EQ(nameAfter([](S& s) { press({"b"}, s); }), "Put clay away");
    EXPECT_EQ(nameAfter([](S& s) { s.scene.sensor.exposure = 2; }), "Exposure");
    EXPECT_EQ(nameAfter([](S& s) { s.scene.camera.target = {1, 0, 0}; }), "Move the camera");
}

TEST(History, BringsBackHowTwoVariantsWereShown)
{
    Desk desk;
    press({"c"}, desk.state);
    desk.frame();
    desk.state.compare.mode = CompareMode::Wipe;
    desk.frame();
    EXPECT_EQ(desk.state.history.undoName(), "Wipe");
    press({"b"}, desk.state); // clay is shown side by side
    desk.frame();
    desk.state.history.undo(desk.state);
    EXPECT_EQ(desk.state.compare.mode, CompareMode::Wipe);
    desk.state.history.undo(desk.state);
    EXPECT_EQ(desk.state.compare.mode, CompareMode::SideBySide);
    desk.state.history.redo(desk.state);
    EXPECT_EQ(desk.state.compare.mode, CompareMode::Wipe);
}

TEST(History, CoversWhatIsKeptUnderNames)
{
    Desk desk;
    keepVariant(desk.state.scene, desk.state.scene.surface);
    desk.frame();
    const std::string name = desk.state.scene.variants[0].name;
    EXPECT_EQ(desk.state.history.undoName(), "Keep " + name);
    ASSERT_TRUE(renameVariant(desk.state.scene, 0, "before"));
    desk.frame();
    EXPECT_EQ(desk.state.history.undoName(), "Rename " + name);
    desk.state.scene.variants.clear();
    desk.frame();
    EXPECT_EQ(desk.state.history.undoName(), "Remove a variant");
    desk.state.history.go(1, desk.state);
    ASSERT_EQ(desk.state.scene.variants.size(), 1U);
    EXPECT_EQ(desk.state.scene.variants[0].name, name);
    desk.state.history.undo(desk.state);
    EXPECT_TRUE(desk.state.scene.variants.empty());
}

TEST(History, LeadsBackFromAHazardsCase)
{
    Desk desk;
    showCase(desk.state, runExtremes(programInstruments(nullptr, "no GL here"), "H04").front());
    desk.frame();
    ASSERT_TRUE(desk.state.putAside);
    EXPECT_THAT(desk.state.history.undoName(), testing::HasSubstr("H04"));
    desk.state.history.undo(desk.state);
    EXPECT_FALSE(desk.state.putAside);
    EXPECT_TRUE(desk.state.scene == desk.start);
    desk.state.history.redo(desk.state);
    EXPECT_TRUE(desk.state.putAside);
}

TEST(History, KeysAskForIt)
{
    using Kind = Request::Kind;
    const std::pair<KeyPress, Kind> table[] = {
        {{"z", true}, Kind::Undo}, {{"z", true, true}, Kind::Redo}, {{"y", true}, Kind::Redo}};
    for (const auto& [key, kind] : table) {
        ExplorerState state;
        press(key, state);
        ASSERT_EQ(state.requests.size(), 1U);
        EXPECT_EQ(state.requests[0].kind, kind);
    }
}

} // namespace
} // namespace reflectance::explorer
