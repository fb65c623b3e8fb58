// Preferences survive a session, and no file can break the next one.
#include "app/explorer/preferences.h"
#include "tests/app/scratch_folder.h"

#include <gmock/gmock.h>

#include <fstream>

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
