// Recordings: what is replayed without a window ends where the session ended, bit for bit; the three in recordings/ are
// sessions of their own that have to go on working.
#include "app/explorer/recording.h"

#include "app/explorer/comparison.h"
#include "app/explorer/state.h"
#include "core/scene/scene_file.h"

#include <gmock/gmock.h>
#include <random>

namespace reflectance::explorer {
namespace {

using testing::HasSubstr;

constexpr ViewSize view{640, 480};

/// A session at a desk: every change as the window makes it, noted as the window notes it.
struct Session {
    ExplorerState state;
    Recorder recorder;

    Session() : state(started()), recorder(state) { state.history.watch(state, {}, {}); }

    static ExplorerState started()
    {
        ExplorerState state;
        state.scene = defaultScene();
        return state;
    }

    void note(const RecordedEvent& event)
    {
        ASSERT_TRUE(replay(event, state)); // a hand does to the state what a replay does
        recorder.note(event);
    }
    void change() // by a panel
    {
        state.history.watch(state, {}, {});
        recorder.settle(state);
    }
};

void act(Session& session, std::mt19937_64& random)
{
    const auto number = [&] { return std::uniform_real_distribution<double>(0.0, 400.0)(random); };
    Scene& scene = session.state.scene;
    switch (random() % 8) {
    case 0:
        session.note(KeyPress{"m", false, random() % 2 == 0});
        break;
    case 1:
        session.note(KeyPress{random() % 2 == 0 ? "c" : "b"});
        break;
    case 2:
        session.note(KeyPress{"z", true, random() % 3 == 0});
        break;
    case 3:
        session.note(RecordedStroke{MouseButton::Left,
                                    {},
                                    view,
                                    static_cast<int>(random() % 3) - 1,
                                    0,
                                    {number(), number()},
                                    {number(), number()}});
        break;
    case 4:
        session.note(
            RecordedStroke{MouseButton::Right, {true, true}, view, -1, 0, {number(), number()}, {number(), number()}});
        break;
    case 5:
        session.note(RecordedWheel{static_cast<double>(random() % 5) - 2.0});
        break;
    case 6:
        surfaceInHand(session.state.compare, scene).values["n"] = {number()};
        session.change();
        break;
    default:
        scene.lights.emplace_back().intensity = Vec3d(number(), 1.0 / 3.0, 0.1);
        session.state.selectedLight = 0;
        session.change();
    }
}

TEST(Recording, EndsWhereTheSessionDidBitForBit)
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Session session;
        std::mt19937_64 random(seed);
        for (int i = 0; i < 40; ++i)
            act(session, random);
        const auto read = parseRecording(recordingText(session.recorder.recording()), "a.json");
        ASSERT_TRUE(read) << read.error().sentence();
        const auto end = replayed(*read);
        ASSERT_TRUE(end) << end.error().sentence();
        EXPECT_EQ(documentOf(*end), documentOf(session.state)) << "seed " << seed;
    }
}

TEST(Recording, MissesAnEventThatWasTakenOut) // planted
{
    Session session;
    session.note(KeyPress{"m"});
    session.note(RecordedWheel{1.0});
    Recording cut = session.recorder.recording();
    cut.events.pop_back();
    EXPECT_NE(documentOf(*replayed(cut)), documentOf(session.state));
}

TEST(Recording, ProbesWhatTheHandProbed)
{
    Session session;
    session.note(RecordedProbe{{320.0, 240.0}, view});
    session.note(KeyPress{"m"});
    const auto read = parseRecording(recordingText(session.recorder.recording()), "a.json");
    ASSERT_TRUE(read) << read.error().sentence();
    const auto end = replayed(*read);
    ASSERT_TRUE(end && end->probe.loose && session.state.probe.loose);
    EXPECT_EQ(end->probe.loose->point.P, session.state.probe.loose->point.P);
    EXPECT_FALSE(end->probe.asked);
    EXPECT_EQ(documentOf(*end), documentOf(session.state)) << "the scene knows nothing of it";
}

TEST(Recording, NotesWhatNoKeyOrStrokeExplains)
{
    Session session;
    session.change();
    EXPECT_TRUE(session.recorder.recording().events.empty()) << "nothing has happened";
    session.state.scene.sensor.exposure = 1.0 / 3.0;
    session.change();
    ASSERT_EQ(session.recorder.recording().events.size(), 1U);
    const auto* edit = std::get_if<RecordedEdit>(&session.recorder.recording().events[0]);
    ASSERT_TRUE(edit);
    EXPECT_THAT(edit->patch, HasSubstr("/scene/sensor/exposure"));
    EXPECT_LT(edit->patch.size(), 200U) << "one value, not the whole scene";
}

TEST(Recording, RefusesWhatIsNone)
{
    for (const auto& [text, problem] : std::vector<std::pair<const char*, const char*>>{
             {"[", "not a recording in JSON"},
             {R"({})", "needs 'start'"},
             {R"({"version": 2})", "newer program"},
             {R"({"schema": "reflectance.scene"})", "another kind of file"},
             {R"({"start": {}, "events": [{"jump": 1}]})", "event 1"},
             {R"({"start": {}, "events": [{"stroke": "left", "width": 0}]})", "event 1.width"},
             {R"({"start": {}, "events": [{"key": "m"}, 3]})", "event 2"}}) {
        const auto read = parseRecording(text, "a.json");
        ASSERT_FALSE(read) << text;
        EXPECT_THAT(read.error().sentence(), HasSubstr(problem));
    }
    Recording recording{R"({"scene": {"mesh": "mug"}})", {RecordedEdit{R"([{"op": "remove", "path": "/nothing"}])"}}};
    const auto end = replayed(recording);
    ASSERT_FALSE(end);
    EXPECT_THAT(end.error().sentence(), HasSubstr("does not fit"));
}

Recording recorded(const std::string& name)
{
    const auto read = loadRecording(std::string(RECORDINGS) + "/" + name);
    EXPECT_TRUE(read) << read.error().sentence();
    return read ? *read : Recording();
}

TEST(Recordings, ADraggedLightMovesNothingElse)
{
    const Recording recording = recorded("drag_a_light.json");
    const auto start = startOf(recording), end = replayed(recording);
    ASSERT_TRUE(start && end);
    EXPECT_NE(start->scene.lights[0].direction, end->scene.lights[0].direction);
    EXPECT_EQ(start->scene.camera, end->scene.camera);
    EXPECT_EQ(start->scene.surface, end->scene.surface);
    // The stroke goes to the right and up, and so does the light.
    const CameraFrame frame = frameOf(end->scene.camera);
    const Vec3d moved = end->scene.lights[0].direction - start->scene.lights[0].direction;
    EXPECT_GT(dot(moved, frame.right), 0.1);
    EXPECT_GT(dot(moved, frame.up), 0.1);
    EXPECT_EQ(end->history.undoName(), "Move key");
}

TEST(Recordings, ClayIsComparedChangedAndPutAway)
{
    const Recording recording = recorded("compare_clay.json");
    Recording first = recording;
    first.events.resize(1);
    const auto start = startOf(recording), clay = replayed(first), end = replayed(recording);
    ASSERT_TRUE(start && clay && end);
    EXPECT_TRUE(clay->compare.on);
    EXPECT_EQ(clay->scene.other->model, "oren_nayar");
    EXPECT_EQ(documentOf(*end), documentOf(*start)) << "the second press brings back what was there";
    EXPECT_EQ(end->history.steps().size(), 4U) << "clay, another model for B, clay put away";
}

TEST(Recordings, UndoLeadsBackThroughEditsAndKeys)
{
    const Recording recording = recorded("undo_edits.json");
    const auto start = startOf(recording), end = replayed(recording);
    ASSERT_TRUE(start && end);
    EXPECT_EQ(sceneText(end->scene, ""), sceneText(start->scene, ""));
    EXPECT_TRUE(end->history.canRedo());
    Recording without = recording; // planted: one undo less is another end
    without.events.pop_back();
    EXPECT_NE(sceneText(replayed(without)->scene, ""), sceneText(start->scene, ""));
}

} // namespace
} // namespace reflectance::explorer
