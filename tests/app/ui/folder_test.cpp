// Listing, filtering and completing paths.
#include "app/explorer/ui/folder.h"
#include "tests/app/scratch_folder.h"

#include <fstream>
#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class FolderTest : public testing::Test {
protected:
    FolderTest()
    {
        fs::create_directory(scratch.path / "meshes");
        fs::create_directory(scratch.path / ".hidden");
        for (const char* name : {"bunny.obj", "Buddha.PLY", "notes.txt", "studio.exr", ".secret.obj"})
            std::ofstream(scratch.path / name) << "12345";
    }

    std::vector<std::string> names(bool everyFile)
    {
        std::vector<std::string> found;
        const auto entries = listFolder(scratch.path, everyFile);
        for (const FolderEntry& entry : *entries)
            found.push_back(entry.name);
        return found;
    }

    ScratchFolder scratch;
};

TEST_F(FolderTest, ListsFoldersFirstThenWhatTheProgramReads)
{
    EXPECT_THAT(names(false), ElementsAre("meshes", "Buddha.PLY", "bunny.obj", "studio.exr"));
    EXPECT_THAT(names(true), ElementsAre("meshes", "Buddha.PLY", "bunny.obj", "notes.txt", "studio.exr"));
}

TEST_F(FolderTest, SaysSizesAndKinds)
{
    const auto entries = listFolder(scratch.path, false);
    EXPECT_TRUE((*entries)[0].isFolder);
    EXPECT_EQ((*entries)[2].size, 5U);
    EXPECT_EQ(kindOfFile("Buddha.PLY"), "mesh");
    EXPECT_EQ(kindOfFile("a.json"), "scene");
    EXPECT_EQ(kindOfFile("a.hdr"), "environment");
    EXPECT_EQ(kindOfFile("a.txt"), "");
}

TEST_F(FolderTest, SaysInASentenceThatAFolderCannotBeRead)
{
    const auto entries = listFolder(scratch.path / "nowhere", false);
    ASSERT_FALSE(entries);
    EXPECT_THAT(entries.error().sentence(), testing::HasSubstr("cannot be read"));
}

TEST_F(FolderTest, FiltersWithoutRegardToCase)
{
    const auto entries = listFolder(scratch.path, false);
    EXPECT_EQ(matching(*entries, "bU").size(), 2U);
    EXPECT_EQ(matching(*entries, "").size(), 4U);
    EXPECT_TRUE(matching(*entries, "teapot").empty());
}

TEST_F(FolderTest, CompletesAsFarAsNamesAgree)
{
    const std::vector<FolderEntry> entries = {
        {"bunny_full.obj", false, 1}, {"bunny_low.obj", false, 1}, {"meshes", true, 0}};
    EXPECT_EQ(completed("b", entries), "bunny_");
    EXPECT_EQ(completed("bunny_l", entries), "bunny_low.obj");
    EXPECT_EQ(completed("me", entries), "meshes/");
    EXPECT_EQ(completed("../x/me", entries), "../x/meshes/");
    EXPECT_EQ(completed("z", entries), "z");
}

TEST(TypedPlaces, LeadFromTheFolderTheRootOrHome)
{
    const fs::path here = "/data/scenes";
    EXPECT_EQ(placeOf(here, "bun").folder, here);
    EXPECT_EQ(placeOf(here, "bun").leaf, "bun");
    EXPECT_EQ(placeOf(here, "../meshes/bun").folder, "/data/meshes/");
    EXPECT_EQ(placeOf(here, "../meshes/bun").leaf, "bun");
    EXPECT_EQ(placeOf(here, "/etc/").folder, "/etc/");
    EXPECT_EQ(placeOf(here, "~").folder, homeFolder());
    EXPECT_EQ(placeOf(here, "~/x").leaf, "x");
}

TEST(Sizes, AreReadable)
{
    EXPECT_EQ(readableSize(812), "812 B");
    EXPECT_EQ(readableSize(65231), "65.2 kB");
    EXPECT_EQ(readableSize(7100000), "7.1 MB");
    EXPECT_EQ(readableSize(3200000000), "3.2 GB");
}

} // namespace
} // namespace reflectance::explorer
