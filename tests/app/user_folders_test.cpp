// Pictures and settings go where the desktop's conventions put them.
#include "app/explorer/user_folders.h"
#include "tests/app/scratch_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;

TEST(UserDirs, NameThePicturesFolder)
{
    const char* text = "# comment\nXDG_MUSIC_DIR=\"$HOME/Music\"\n  XDG_PICTURES_DIR=\"$HOME/Bilder\"\n";
    EXPECT_EQ(picturesFolderIn(text, "/home/ada"), fs::path("/home/ada/Bilder"));
    EXPECT_EQ(picturesFolderIn("XDG_PICTURES_DIR=\"/media/shots\"", "/home/ada"), fs::path("/media/shots"));
    EXPECT_EQ(picturesFolderIn("XDG_PICTURES_DIR=\"shots\"", "/home/ada"), fs::path()); // relative ones are not allowed
    EXPECT_EQ(picturesFolderIn("#XDG_PICTURES_DIR=\"/media/shots\"", "/home/ada"), fs::path());
    EXPECT_EQ(picturesFolderIn("", "/home/ada"), fs::path());
}

TEST(UserFolders, FollowTheEnvironment)
{
    const ScratchFolder home;
    ::setenv("HOME", home.path.c_str(), 1);
    ::unsetenv("XDG_CONFIG_HOME");
    ::unsetenv("XDG_STATE_HOME");
    EXPECT_EQ(settingsFolder(), home.path / ".config" / "reflectance");
    EXPECT_EQ(stateFolder(), home.path / ".local" / "state" / "reflectance");
    ::unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(programsFolder(), home.path / ".cache" / "reflectance" / "programs");
    EXPECT_EQ(backendsFile(), home.path / ".cache" / "reflectance" / "backends");
    ::setenv("XDG_STATE_HOME", "/var/state", 1);
    EXPECT_EQ(stateFolder(), fs::path("/var/state/reflectance"));
    EXPECT_EQ(picturesFolder(), home.path);
    fs::create_directory(home.path / "Pictures");
    EXPECT_EQ(picturesFolder(), home.path / "Pictures");

    const fs::path config = home.path / "config";
    fs::create_directories(config);
    fs::create_directory(home.path / "Bilder");
    std::ofstream(config / "user-dirs.dirs") << "XDG_PICTURES_DIR=\"$HOME/Bilder\"\n";
    ::setenv("XDG_CONFIG_HOME", config.c_str(), 1);
    EXPECT_EQ(settingsFolder(), config / "reflectance");
    EXPECT_EQ(picturesFolder(), home.path / "Bilder");
    ::setenv("XDG_CONFIG_HOME", "relative", 1); // to be ignored, says the specification
    EXPECT_EQ(settingsFolder(), home.path / ".config" / "reflectance");
}

TEST(FreeNames, CountOnAndNeedNoQuoting)
{
    const ScratchFolder scratch;
    const fs::path first = freeName(scratch.path, "mug", "hybrid", ".png");
    EXPECT_EQ(first.filename(), "reflectance-mug-hybrid-1.png");
    std::ofstream(first) << "taken";
    EXPECT_EQ(freeName(scratch.path, "mug", "hybrid", ".png").filename(), "reflectance-mug-hybrid-2.png");
    EXPECT_EQ(freeName(scratch.path, "a/b ö", "m", ".json").filename(), "reflectance-a_b___-m-1.json");
    // A dangling link is not free either: writing would follow it.
    fs::create_symlink(scratch.path / "nowhere", scratch.path / "reflectance-mug-hybrid-2.png");
    EXPECT_EQ(freeName(scratch.path, "mug", "hybrid", ".png").filename(), "reflectance-mug-hybrid-3.png");
}

} // namespace
} // namespace reflectance::explorer
