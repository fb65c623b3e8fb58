// The tool Grab: what the hand holds comes under the cursor, a stroke is one step of undo, and a recording does it again.
#include "app/explorer/grab_tool.h"

#include "app/explorer/keys.h"
#include "app/explorer/recording.h"
#include "core/study/grab/grab.h"
#include "core/study/grab/width.h"

#include <cmath>
#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

using testing::HasSubstr;

constexpr ViewSize size{640, 480};
constexpr double reach = 6.0;

/// A glossy ball in the middle of the picture, lit from beside the eye.
ExplorerState ballState()
{
    static const Scene fresh = [] {
        Scene scene = defaultScene();
        scene.meshFile = "sphere";
        EXPECT_TRUE(readMeshOf(scene));
        scene.camera = {{0.0, 0.0, 4.0}, {}, {0.0, 1.0, 0.0}, 35.0};
        scene.lights.resize(1);
        scene.lights[0].direction = normalized(Vec3d(0.5, 0.3, 1.0));
        scene.surface.values["n"] = {40.0};
        return scene;
    }();
    ExplorerState state;
    state.scene = fresh;
    state.grab.on = true;
    state.grab.view = size;
    state.history.watch(state, {}, {});
    return state;
}

ProbedPoint spotOf(const ExplorerState& state)
{
    const auto spot = spotIn(state.scene, state.scene.lights[0], size.width, size.height);
    EXPECT_TRUE(spot);
    return spot.value_or(ProbedPoint());
}

Stroke strokeAt(const ExplorerState& state, Cursor cursor)
{
    bool isThere = false;
    const auto grasp = graspUnder(cursor, reach, size, state.compare, state.scene, state.selectedLight, isThere);
    return grasp ? grabStroke(*grasp, cursor, size, state.compare, state.scene) : Stroke();
}

/// Where the lobe has half its height, to the right of the spot.
Cursor edgeOf(const ExplorerState& state)
{
    const ProbedPoint spot = spotOf(state);
    for (double x = spot.x; x < size.width; x += 0.5) {
        const auto point = pointAt(*state.scene.mesh, state.scene.camera, x, spot.y, size.width, size.height);
        if (!point || *spotHeight(state.scene, state.scene.lights[0], *point) < 0.5)
            return {x, spot.y};
    }
    ADD_FAILURE() << "no edge";
    return {};
}

TEST(GrabTool, BringsTheHighlightUnderTheHand)
{
    ExplorerState state = ballState();
    const ProbedPoint spot = spotOf(state);
    const Stroke stroke = strokeAt(state, {spot.x, spot.y});
    ASSERT_EQ(stroke.kind, Stroke::Kind::Grab);
    EXPECT_EQ(stroke.taken, Grip::Spot);
    const Cursor to{spot.x - 90.0, spot.y + 40.0};
    ASSERT_TRUE(follow(stroke, size, to, state.compare, state.scene));
    const ProbedPoint now = spotOf(state);
    EXPECT_LT(std::hypot(now.x - to.x, now.y - to.y), 1.0);
    state.history.watch(state, {}, {});
    EXPECT_EQ(state.history.steps().size(), 2U) << "one stroke, one step";
    state.history.undo(state);
    EXPECT_EQ(state.scene.lights[0], ballState().scene.lights[0]);
}

TEST(GrabTool, AClickChangesNothing)
{
    ExplorerState state = ballState();
    const ProbedPoint spot = spotOf(state);
    const Light before = state.scene.lights[0];
    EXPECT_TRUE(follow(strokeAt(state, {spot.x, spot.y}), size, {spot.x, spot.y}, state.compare, state.scene));
    EXPECT_EQ(state.scene.lights[0], before);
}

TEST(GrabTool, BackWhereItBeganEverythingIsAsItWas)
{
    ExplorerState state = ballState();
    const Scene before = state.scene;
    const ProbedPoint spot = spotOf(state);
    for (const Cursor start : {Cursor{spot.x, spot.y}, edgeOf(state)}) {
        const Stroke stroke = strokeAt(state, start);
        ASSERT_TRUE(follow(stroke, size, {start.x + 30.0, start.y}, state.compare, state.scene));
        EXPECT_FALSE(state.scene == before);
        ASSERT_TRUE(follow(stroke, size, start, state.compare, state.scene));
        EXPECT_TRUE(state.scene == before);
    }
}

TEST(GrabTool, AnEdgeFollowsTheHandByItsExponent)
{
    ExplorerState state = ballState();
    const Cursor edge = edgeOf(state);
    const Stroke stroke = strokeAt(state, edge);
    ASSERT_EQ(stroke.taken, Grip::Edge);
    const Light before = state.scene.lights[0];
    const Cursor to{edge.x + 30.0, edge.y};
    ASSERT_TRUE(follow(stroke, size, to, state.compare, state.scene));
    EXPECT_LT(state.scene.surface.values["n"].front(), 40.0) << "a wider highlight";
    EXPECT_NEAR(edgeOf(state).x, to.x, 1.5); // the search steps by half a pixel, the edge was taken within one
    EXPECT_EQ(state.scene.lights[0], before);
    state.history.watch(state, {}, {});
    EXPECT_EQ(state.history.undoName(), "Phong exponent");
}

TEST(GrabTool, AnEdgeFollowsTheHandWhateverItsNumberIsCalled)
{
    const std::pair<const char*, const char*> numbers[] = {
        {"blinn_phong", "n"}, {"cook_torrance", "m"}, {"ward", "alpha"}, {"ggx", "alpha"}};
    for (const auto& [model, number] : numbers) {
        ExplorerState state = ballState();
        state.scene.surface = Surface();
        state.scene.surface.model = model;
        if (std::string(number) != "n")
            state.scene.surface.values[number] = {0.12};
        const Cursor edge = edgeOf(state);
        const Stroke stroke = strokeAt(state, edge);
        ASSERT_EQ(stroke.taken, Grip::Edge) << model;
        const Cursor to{edge.x + 20.0, edge.y};
        ASSERT_TRUE(follow(stroke, size, to, state.compare, state.scene));
        EXPECT_NEAR(edgeOf(state).x, to.x, 1.5)
            << model; // the search steps by half a pixel, the edge was taken within one
        EXPECT_THAT(nameOf({Grip::Edge, 0, 0.0}, state.compare, state.scene), HasSubstr(std::string(", ") + number));
        const double wide = state.scene.surface.values[number].front();
        press({"Up", false, true}, state);
        EXPECT_EQ(state.scene.surface.values[number].front() > wide, std::string(number) == "n") << "narrower";
    }
}

TEST(GrabTool, ATerminatorFollowsTheHand)
{
    ExplorerState state = ballState();
    state.scene.lights[0].direction =
        normalized(Vec3d(1.0, 0.0, -0.5)); // its terminator crosses the ball right of its middle
    std::optional<Cursor> line;
    for (double x = 250.0; x < 480.0 && !line; x += 1.0)
        if (strokeAt(state, {x, 240.0}).kind == Stroke::Kind::Grab &&
            strokeAt(state, {x, 240.0}).taken == Grip::Terminator)
            line = Cursor{x, 240.0};
    ASSERT_TRUE(line);
    const Cursor to{line->x - 40.0, 240.0};
    ASSERT_TRUE(follow(strokeAt(state, *line), size, to, state.compare, state.scene));
    const auto point = pointAt(*state.scene.mesh, state.scene.camera, to.x, to.y, size.width, size.height);
    EXPECT_NEAR(dot(point->N, state.scene.lights[0].direction), 0.0, 1e-12);
}

TEST(GrabTool, BesideTheObjectTheLightStays)
{
    ExplorerState state = ballState();
    const ProbedPoint spot = spotOf(state);
    const Light before = state.scene.lights[0];
    const auto followed = follow(strokeAt(state, {spot.x, spot.y}), size, {2.0, 2.0}, state.compare, state.scene);
    ASSERT_FALSE(followed);
    EXPECT_THAT(followed.error().sentence(), HasSubstr("go back onto it"));
    EXPECT_EQ(state.scene.lights[0], before);
    EXPECT_EQ(strokeAt(state, {2.0, 2.0}).kind, Stroke::Kind::None) << "there is nothing to take";
    state.selectedLight = -1;
    EXPECT_EQ(strokeAt(state, {spot.x - 120.0, spot.y + 60.0}).kind, Stroke::Kind::None) << "no light to bring";
}

TEST(GrabTool, ChangesTheSurfaceThatTheHandIsOn)
{
    ExplorerState state = ballState();
    toggleCompare(state.compare, state.scene);
    state.compare.handOnB = true;
    const Cursor edge = edgeOf(state);
    ASSERT_TRUE(follow(strokeAt(state, edge), size, {edge.x + 20.0, edge.y}, state.compare, state.scene));
    EXPECT_EQ(state.scene.surface.values["n"].front(), 40.0);
    EXPECT_NE(state.scene.other->values["n"].front(), 40.0);
}

TEST(GrabTool, KeysMoveTheSpotAndItsEdge)
{
    ExplorerState state = ballState();
    const ProbedPoint before = spotOf(state);
    for (int i = 0; i < 5; ++i)
        press({"Left"}, state);
    press({"Up", true}, state);
    const ProbedPoint now = spotOf(state);
    // Where the keys begin the spot is known to a quarter of a pixel, and so it is found again.
    EXPECT_NEAR(now.x, before.x - 40.0, 1.0); // the peak is held to a pixel
    EXPECT_NEAR(now.y, before.y - 1.0, 1.0);
    press({"Up", false, true}, state);
    EXPECT_NEAR(state.scene.surface.values["n"].front(), 40.0 * std::exp2(0.25), 1e-12);
    state.grab.on = false;
    const Scene still = state.scene;
    press({"Left"}, state);
    EXPECT_EQ(state.scene.lights, still.lights) << "without the tool, arrows belong to the controls";
    press({"s"}, state);
    EXPECT_TRUE(state.grab.on);
}

TEST(GrabTool, AHeldKeyIsOneStepOfUndo)
{
    ExplorerState state = ballState();
    const Light before = state.scene.lights[0];
    History::Time now{};
    for (int i = 0; i < 5; ++i) {
        press({"Left"}, state);
        state.history.watch(state, {}, now += std::chrono::milliseconds(100));
    }
    EXPECT_EQ(state.history.steps().size(), 2U);
    press({"Left"}, state);
    state.history.watch(state, {}, now + std::chrono::seconds(2));
    EXPECT_EQ(state.history.steps().size(), 3U) << "after a rest it is another step";
    state.history.go(0, state);
    EXPECT_EQ(state.scene.lights[0], before);
}

TEST(GrabTool, ASpotThatIsNotSeenIsSaidInASentence)
{
    ExplorerState state = ballState();
    state.scene.meshFile = "cube";
    ASSERT_TRUE(readMeshOf(state.scene));
    state.scene.lights[0].direction = {0.0, 0.0, -1.0};
    press({"Left"}, state);
    ASSERT_TRUE(state.message);
    EXPECT_THAT(state.message->text, HasSubstr("brings it there"));
}

TEST(GrabTool, ARecordingDoesItAgain)
{
    ExplorerState state = ballState();
    Recorder recorder(state);
    const ProbedPoint spot = spotOf(state);
    RecordedStroke stroke{MouseButton::Left, {}, size, -1, 0, {spot.x, spot.y}, {spot.x + 30.0, spot.y}, Grasp()};
    ASSERT_TRUE(replay(stroke, state));
    recorder.note(stroke);
    recorder.settle(state);
    EXPECT_EQ(recorder.recording().events.size(), 1U) << "the stroke explains everything";
    const auto read = parseRecording(recordingText(recorder.recording()), "a.json");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(documentOf(*replayed(*read)), documentOf(state));
    Recording planted = *read;
    std::get<RecordedStroke>(planted.events[0]).grasp->grip = Grip::Terminator;
    EXPECT_NE(documentOf(*replayed(planted)), documentOf(state));
}

} // namespace
} // namespace reflectance::explorer
