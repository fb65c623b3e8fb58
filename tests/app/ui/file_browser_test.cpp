// The file browser from the keyboard alone.
#include "app/explorer/ui/ui.h"
#include "tests/app/scratch_folder.h"
#include "tests/app/ui/stage.h"

#include <fstream>
#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;

class FileBrowserTest : public testing::Test {
protected:
    FileBrowserTest()
    {
        fs::create_directory(scratch.path / "meshes");
        std::ofstream(scratch.path / "meshes" / "bunny.obj") << "v";
        std::ofstream(scratch.path / "meshes" / "teapot.obj") << "v";
        state.panels.browser.folder = scratch.path;
        state.showFileBrowser = true;
        // The first frames open it and give the path line the keyboard.
        for (int i = 0; i < 4; ++i)
            stage.frame(draw);
    }

    std::vector<std::string> opened() const
    {
        std::vector<std::string> paths;
        for (const Request& request : state.requests)
            if (request.kind == Request::Kind::OpenFile)
                paths.push_back(request.path);
        return paths;
    }

    void enter()
    {
        stage.press(ImGuiKey_Enter, draw);
        for (int i = 0; i < 3; ++i)
            stage.frame(draw);
    }

    ScratchFolder scratch;
    Stage stage;
    ExplorerState state;
    Stage::Draw draw = [this] { drawFileBrowser(state); };
};

TEST_F(FileBrowserTest, EntersAFolderAndOpensAFile)
{
    enter(); // the only entry is the folder
    EXPECT_EQ(state.panels.browser.folder, scratch.path / "meshes");
    EXPECT_TRUE(state.showFileBrowser);
    stage.type("tea", draw);
    enter();
    EXPECT_THAT(opened(), testing::ElementsAre((scratch.path / "meshes" / "teapot.obj").string()));
    EXPECT_FALSE(state.showFileBrowser);
}

TEST_F(FileBrowserTest, ArrowsSelectWhileTyping)
{
    enter();
    stage.press(ImGuiKey_DownArrow, draw);
    enter();
    EXPECT_THAT(opened(), testing::ElementsAre((scratch.path / "meshes" / "teapot.obj").string()));
}

TEST_F(FileBrowserTest, TabCompletesAPath)
{
    stage.type("me", draw);
    stage.press(ImGuiKey_Tab, draw);
    EXPECT_EQ(state.panels.browser.typed, "meshes/");
    stage.type("b", draw);
    stage.press(ImGuiKey_Tab, draw);
    EXPECT_EQ(state.panels.browser.typed, "meshes/bunny.obj");
    enter();
    EXPECT_THAT(opened(), testing::ElementsAre((scratch.path / "meshes" / "bunny.obj").string()));
}

TEST_F(FileBrowserTest, EscapeClosesWithoutOpening)
{
    stage.press(ImGuiKey_Escape, draw);
    stage.press(ImGuiKey_Escape, draw);
    EXPECT_FALSE(state.showFileBrowser);
    EXPECT_TRUE(opened().empty());
}

TEST_F(FileBrowserTest, OpensATypedPathThatIsNotThereSoThatItsErrorIsSaid)
{
    stage.type("nothing.obj", draw);
    enter();
    EXPECT_THAT(opened(), testing::ElementsAre((scratch.path / "nothing.obj").string()));
}

TEST_F(FileBrowserTest, SaysThatAFolderCannotBeRead)
{
    stage.type("nowhere/", draw);
    stage.frame(draw);
    ASSERT_TRUE(state.panels.browser.listing);
    EXPECT_THAT(state.panels.browser.listing->problem, testing::HasSubstr("cannot be read"));
}

} // namespace
} // namespace reflectance::explorer
