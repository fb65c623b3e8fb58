// No session is lost without the user's will: programs that stop anywhere, several at once, folders that refuse.
#include "app/explorer/autosave.h"
#include "core/base/file.h"
#include "core/scene/scene_file.h"
#include "tests/app/scratch_folder.h"

#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A scene that tells itself apart by its exposure.
Scene exposed(double stops)
{
    Scene scene = defaultScene();
    scene.sensor.exposure = stops;
    return scene;
}

/// The explorer's frames, without a window.
struct Program {
    explicit Program(const fs::path& folder) : autosave(folder) { autosave.settle(scene); }

    void show(const Scene& changed)
    {
        scene = changed;
        autosave.watch(scene, now);
        now += Autosave::pause;
        autosave.watch(scene, now);
        autosave.finishWriting();
    }

    void restore(const std::string& file)
    {
        const Result<Scene> read = loadScene(file);
        ASSERT_TRUE(read) << read.error().sentence();
        autosave.adopt(file, scene, *read);
        scene = *read;
    }

    [[nodiscard]] std::vector<std::string> offered() const
    {
        std::vector<std::string> files;
        for (const EarlierSession& session : autosave.earlier())
            if (!session.dismissed)
                files.push_back(session.file);
        return files;
    }

    Scene scene = defaultScene();
    Autosave::Clock::time_point now{};
    Autosave autosave; ///< that it goes without end() is the crash
};

std::vector<std::string> namesIn(const fs::path& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    return names;
}

/// What the programs leave when they crash with these scenes, one after the other, none restoring anything.
void crashWith(const fs::path& folder, const std::vector<double>& exposures)
{
    for (const double stops : exposures)
        Program(folder).show(exposed(stops));
}

TEST(Autosave, ACrashedSessionIsOfferedAndComesBack)
{
    const ScratchFolder scratch;
    crashWith(scratch.path / "new", {1.25});
    Program next(scratch.path / "new");
    ASSERT_THAT(next.offered(), SizeIs(1));
    EXPECT_EQ(next.autosave.earlier()[0].content, "mug, hybrid, 2 lights");
    EXPECT_EQ(next.autosave.earlier()[0].when, "just now");
    next.restore(next.offered()[0]);
    EXPECT_EQ(next.scene.sensor.exposure, 1.25);
    EXPECT_THAT(next.autosave.earlier(), IsEmpty());
}

TEST(Autosave, ACleanEndLeavesNothing)
{
    const ScratchFolder scratch;
    {
        Program program(scratch.path);
        program.show(exposed(1.0));
        EXPECT_THAT(namesIn(scratch.path), testing::UnorderedElementsAre("session-1.json", "session-1.lock"));
        program.autosave.end();
    }
    EXPECT_THAT(namesIn(scratch.path), IsEmpty());
    EXPECT_THAT(Program(scratch.path).offered(), IsEmpty());
}

TEST(Autosave, OnlyLookingWritesNothing)
{
    const ScratchFolder scratch;
    Program program(scratch.path / "state");
    program.show(program.scene);
    EXPECT_FALSE(fs::exists(scratch.path / "state"));
    EXPECT_EQ(program.autosave.secondsUntilWrite(program.now), std::numeric_limits<double>::infinity());
}

TEST(Autosave, ALongDragIsKeptWhileItLasts)
{
    const ScratchFolder scratch;
    Program program(scratch.path);
    const auto start = program.now;
    // Three seconds of change at 10 frames a second: never two seconds of rest, yet the first two seconds are kept.
    for (int frame = 0; frame < 30; ++frame)
        program.autosave.watch(exposed(1.0 + 0.25 * frame), start + frame * std::chrono::milliseconds(100));
    program.autosave.finishWriting();
    const Result<Scene> kept = loadScene((scratch.path / "session-1.json").string());
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->sensor.exposure, 6.0); // of frame 20
}

TEST(Autosave, ASavedSceneNeedsNoKeeping)
{
    const ScratchFolder scratch;
    {
        Program program(scratch.path);
        program.show(exposed(1.0));
        program.autosave.settle(program.scene);
    }
    EXPECT_THAT(Program(scratch.path).offered(), IsEmpty());
}

TEST(Autosave, NothingIsLostByNotAnswering)
{
    const ScratchFolder scratch;
    crashWith(scratch.path, {1.0, 2.0, 3.0});
    for (int start = 0; start < 3; ++start) {
        Program program(scratch.path);
        EXPECT_THAT(program.offered(), SizeIs(3));
        program.autosave.end();
    }
}

TEST(Autosave, DismissedSessionsGoWithTheNextCleanEndOnly)
{
    const ScratchFolder scratch;
    crashWith(scratch.path, {1.0, 2.0});
    {
        Program crashing(scratch.path);
        crashing.autosave.dismiss(crashing.offered()[0]);
        EXPECT_THAT(crashing.offered(), SizeIs(1));
        EXPECT_THAT(crashing.autosave.earlier(), SizeIs(2)); // the Open menu still has it
    }
    Program program(scratch.path);
    ASSERT_THAT(program.offered(), SizeIs(2));
    program.autosave.dismiss(program.offered()[0]);
    program.autosave.end();
    EXPECT_THAT(Program(scratch.path).offered(), SizeIs(1));
}

TEST(Autosave, RestoringTradesPlacesWithTheWorkOnScreen)
{
    const ScratchFolder scratch;
    crashWith(scratch.path, {1.0});
    Program program(scratch.path);
    const std::string earlier = program.offered()[0];
    program.show(exposed(2.0));
    program.scene = exposed(2.5); // changed again, and not yet written
    program.autosave.watch(program.scene, program.now);
    program.restore(earlier);
    EXPECT_EQ(program.scene.sensor.exposure, 1.0);
    EXPECT_THAT(program.offered(), IsEmpty());
    ASSERT_THAT(program.autosave.earlier(), SizeIs(1));
    program.restore(program.autosave.earlier()[0].file);
    EXPECT_EQ(program.scene.sensor.exposure, 2.5);
}

TEST(Autosave, ARestoredSessionSurvivesTheNextCrash)
{
    const ScratchFolder scratch;
    crashWith(scratch.path, {1.0});
    {
        Program program(scratch.path);
        program.restore(program.offered()[0]);
    }
    EXPECT_THAT(Program(scratch.path).offered(), SizeIs(1));
}

TEST(Autosave, ProgramsThatRunTogetherDoNotFight)
{
    const ScratchFolder scratch;
    Program first(scratch.path), second(scratch.path);
    first.show(exposed(1.0));
    second.show(exposed(2.0));
    EXPECT_THAT(Program(scratch.path).offered(), IsEmpty()) << "both still run";
    second.autosave.end();
    const Result<Scene> kept = loadScene((scratch.path / "session-1.json").string());
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->sensor.exposure, 1.0);
}

TEST(Autosave, TwoThatStartAfterACrashDoNotBothOfferIt)
{
    const ScratchFolder scratch;
    crashWith(scratch.path, {1.0});
    const Program first(scratch.path), second(scratch.path);
    EXPECT_THAT(first.offered(), SizeIs(1));
    EXPECT_THAT(second.offered(), IsEmpty());
}

TEST(Autosave, AKilledProcessIsNoticed)
{
    const ScratchFolder scratch;
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        Program program(scratch.path);
        program.show(exposed(1.5));
        if (::write(ready[1], "", 1) == 1)
            ::pause();
        ::_exit(1);
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    EXPECT_THAT(Program(scratch.path).offered(), IsEmpty()) << "planted: while it runs, its session is its own";
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    EXPECT_THAT(Program(scratch.path).offered(), SizeIs(1));
}

TEST(Autosave, HalfWrittenAndForeignFilesDoNoHarm)
{
    const ScratchFolder scratch;
    crashWith(scratch.path, {1.0});
    for (const char* name : {"session-1.json.4711.tmp", "session-2.json.4712.tmp", "session-.json", "session-x.json",
                             "session-1.json.bak", "notes.txt"})
        std::ofstream(scratch.path / name) << "{\"mesh\": \"mu";
    Program program(scratch.path);
    ASSERT_THAT(program.offered(), ElementsAre((scratch.path / "session-1.json").string()));
    program.show(exposed(2.0));
    EXPECT_FALSE(fs::exists(scratch.path / "session-1.json.4711.tmp"));
    EXPECT_FALSE(fs::exists(scratch.path / "session-2.json.4712.tmp"));
    EXPECT_TRUE(fs::exists(scratch.path / "notes.txt"));
}

TEST(Autosave, ADamagedSessionIsStillOfferedAndKept)
{
    const ScratchFolder scratch;
    std::ofstream(scratch.path / "session-7.json") << "{\"mesh\": \"mu";
    Program program(scratch.path);
    ASSERT_THAT(program.offered(), SizeIs(1));
    EXPECT_EQ(program.autosave.earlier()[0].content, "");
    program.autosave.end();
    EXPECT_TRUE(fs::exists(scratch.path / "session-7.json"));
}

TEST(Autosave, AFolderThatRefusesIsOneSentenceOnce)
{
    const ScratchFolder scratch;
    std::ofstream(scratch.path / "file") << "a file cannot hold a folder, whoever asks";
    Program program(scratch.path / "file" / "reflectance");
    EXPECT_FALSE(program.autosave.takeProblem()) << "nothing to keep yet";
    program.show(exposed(1.0));
    const std::optional<Error> problem = program.autosave.takeProblem();
    ASSERT_TRUE(problem);
    EXPECT_THAT(problem->sentence(), testing::HasSubstr((scratch.path / "file").string()));
    program.show(exposed(2.0));
    EXPECT_FALSE(program.autosave.takeProblem());
    fs::remove(scratch.path / "file");
    program.show(exposed(3.0));
    EXPECT_TRUE(fs::exists(scratch.path / "file" / "reflectance" / "session-1.json")) << "it goes on trying";
}

TEST(Autosave, AFullDiskKeepsWhatWasWrittenBefore)
{
    const ScratchFolder scratch;
    Program program(scratch.path);
    program.show(exposed(1.0));
    // A limit on a file's size stands in for the full disk: both fail the write half-way.
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit tight{100, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    program.show(exposed(2.0));
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_TRUE(program.autosave.takeProblem());
    const Result<Scene> kept = loadScene((scratch.path / "session-1.json").string());
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->sensor.exposure, 1.0);
    EXPECT_THAT(namesIn(scratch.path), SizeIs(2)) << "nothing half-written stays";
}

TEST(Autosave, WithoutAHomeNothingIsKeptAndNothingIsWrong)
{
    Program program({});
    program.show(exposed(1.0));
    EXPECT_FALSE(program.autosave.takeProblem());
    EXPECT_THAT(program.offered(), IsEmpty());
    program.autosave.end();
}

TEST(Autosave, TellsTheTime)
{
    using std::chrono::hours, std::chrono::minutes, std::chrono::seconds;
    EXPECT_EQ(ago(seconds(-5)), "just now"); // a clock that was set back
    EXPECT_EQ(ago(seconds(60)), "1 minute ago");
    EXPECT_EQ(ago(minutes(59)), "59 minutes ago");
    EXPECT_EQ(ago(hours(1)), "1 hour ago");
    EXPECT_EQ(ago(hours(49)), "2 days ago");
}

} // namespace
} // namespace reflectance::explorer
