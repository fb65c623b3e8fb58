// Preferences survive a session, and no file can break the next one.
#include "app/explorer/preferences.h"
#include "tests/app/scratch_folder.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;

TEST(Preferences, RoundTripThroughAFolderThatIsMade)
{
    const ScratchFolder scratch;
    Preferences preferences;
    preferences.recentFiles = {"/meshes/b.obj", "/meshes/with \"quotes\" and ö.obj"};
    preferences.windowWidth = 1600;
    preferences.panelWidth = 412.5F;
    preferences.samplesPerAxis = 3;
    preferences.showLightHandles = false;
    const fs::path folder = scratch.path / "new" / "reflectance";
    ASSERT_TRUE(savePreferences(preferences, folder));
    const Result<Preferences> loaded = loadPreferences(folder);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(preferencesText(*loaded), preferencesText(preferences));
    EXPECT_NE(preferencesText(*loaded), preferencesText(Preferences())); // planted: the text must tell them apart
}

TEST(Preferences, AreTheDefaultsWithoutAFile)
{
    const ScratchFolder scratch;
    const Result<Preferences> loaded = loadPreferences(scratch.path / "nowhere");
    ASSERT_TRUE(loaded);
    EXPECT_EQ(preferencesText(*loaded), preferencesText(Preferences()));
    EXPECT_TRUE(savePreferences(Preferences(), {})); // no home: nothing to write, nothing wrong
}

TEST(Preferences, ADamagedFileIsSaidByName)
{
    const ScratchFolder scratch;
    for (const char* text : {"", "{", "[1, 2]", "\xFF\xFE", "{\"windowWidth\": 12"}) {
        std::ofstream(scratch.path / "preferences.json") << text;
        const Result<Preferences> loaded = loadPreferences(scratch.path);
        ASSERT_FALSE(loaded) << text;
        EXPECT_THAT(loaded.error().sentence(), testing::HasSubstr("preferences.json"));
    }
}

TEST(Preferences, AKillWhileWritingLeavesTheOldOrTheNew)
{
    const ScratchFolder scratch;
    Preferences wide;
    wide.windowWidth = 1600;
    wide.recentFiles.assign(10, std::string(100'000, 'x')); // long enough to be caught half-way
    ASSERT_TRUE(savePreferences(wide, scratch.path));
    for (int round = 0; round < 8; ++round) {
        const pid_t child = ::fork();
        if (child == 0)
            for (int width = 1000;; width = 3000 - width) {
                wide.windowWidth = width;
                if (!savePreferences(wide, scratch.path))
                    ::_exit(1);
            }
        std::this_thread::sleep_for(std::chrono::milliseconds(5 + 3 * round));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const Result<Preferences> loaded = loadPreferences(scratch.path);
        ASSERT_TRUE(loaded) << loaded.error().sentence();
        EXPECT_EQ(loaded->recentFiles.size(), 10U);
        EXPECT_TRUE(savePreferences(wide, scratch.path)) << "what the kill left half-written is in the way";
    }
    // Planted: the same text cut short is noticed.
    std::ofstream(scratch.path / "preferences.json") << preferencesText(wide).substr(0, 50'000);
    EXPECT_FALSE(loadPreferences(scratch.path));
}

TEST(Preferences, ValuesOfOtherKindsAndRangesDoNoHarm)
{
    const char* text = R"({"windowWidth": 1e300, "windowHeight": "tall", "samplesPerAxis": -3, "panelWidth": null,
        "recentFiles": [1, "a", {}, "b"], "showLightHandles": 1, "ofTheFuture": true})";
    const Result<Preferences> parsed = parsePreferences(text, "f");
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->windowWidth, 16384);
    EXPECT_EQ(parsed->windowHeight, Preferences().windowHeight);
    EXPECT_EQ(parsed->samplesPerAxis, 1);
    EXPECT_EQ(parsed->panelWidth, Preferences().panelWidth);
    EXPECT_THAT(parsed->recentFiles, testing::ElementsAre("a", "b"));
    EXPECT_TRUE(parsed->showLightHandles);
}

TEST(RecentFiles, NewestFirstEachOnceAtMostTen)
{
    Preferences preferences;
    for (int i = 0; i < 12; ++i)
        remember(preferences, std::to_string(i));
    remember(preferences, "5");
    EXPECT_THAT(preferences.recentFiles, testing::ElementsAre("5", "11", "10", "9", "8", "7", "6", "4", "3", "2"));
}

} // namespace
} // namespace reflectance::explorer
