// The menu of rungs: it changes the surface in hand, and says what it is for.
#include "app/explorer/ui/rung_row.h"

#include "app/explorer/ui/widgets.h"
#include "tests/app/ui/sweep.h"

#include <gmock/gmock.h>
#include <set>

namespace reflectance::explorer {
namespace {

const ImVec2 place{0.0F, 0.0F}, size{340.0F, 900.0F};

struct Row {
    ExplorerState state;
    Stage stage{size.x, size.y};
    Stage::Draw draw = [this] {
        ImGui::SetNextWindowPos(place);
        ImGui::SetNextWindowSize({size.x, 60.0F});
        ImGui::Begin("rows", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        rungRow(state);
        ImGui::End();
    };

    Row() { state.scene = defaultScene(); }
};

TEST(RungRow, TakesARungForTheSurfaceInHand)
{
    Row row;
    row.state.scene.other = row.state.scene.surface;
    row.state.compare.on = row.state.compare.handOnB = true;
    std::set<std::vector<std::string>> taken;
    for (float y = 40.0F; y < 300.0F; y += 6.0F) {
        row.stage.click({250.0F, 20.0F}, row.draw); // opens the menu
        row.stage.click({250.0F, y}, row.draw);
        taken.insert(row.state.scene.other->rungs);
    }
    EXPECT_TRUE(row.state.scene.surface.rungs.empty()) << "A is not in hand";
    EXPECT_TRUE(taken.contains({"double"}));
}

TEST(RungRow, SaysWhatItDoes)
{
    Row row;
    row.state.scene.surface.rungs = {"k_diagonal"};
    row.state.idleRungsA = {{"k_diagonal", "K is diagonal already"}};
    const Faults faults = sweep(row.stage, place, {size.x, 40.0F}, {6.0F, 5.0F}, row.draw);
    EXPECT_TRUE(faults.silent.empty());
    EXPECT_EQ(faults.controls, 1U);
    EXPECT_EQ(rungsText(row.state.scene.surface), "k_diagonal");
    EXPECT_EQ(rungsText(Surface()), "");
}

} // namespace
} // namespace reflectance::explorer
