// The workbench's tabs open and close its pages; every page draws, and explains its controls.
#include "app/explorer/ui/ui.h"
#include "app/explorer/ui/workbench/page.h"
#include "tests/app/ui/sweep.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

const ImVec2 corner{0.0F, 0.0F};
const ImVec2 benchSize{900.0F, 300.0F};

ExplorerState stateWithScene()
{
    ExplorerState state;
    state.scene = defaultScene();
    state.sensorStudy.waterfall =
        Waterfall{{{"precision", 1e-9, 1e-7, 0.0}, {"encoding", 1e-3, 2e-3, 1.0}}, 1e-3, 2e-3};
    return state;
}

TEST(Workbench, NamesEachPageOnce)
{
    for (const WorkbenchPage& page : workbenchPages()) {
        ExplorerState state;
        togglePage(state, page.id);
        EXPECT_EQ(openPage(state), &page);
        togglePage(state, page.id);
        EXPECT_EQ(openPage(state), nullptr);
    }
}

TEST(Workbench, TakesAnUnknownPageOfOtherPreferencesForNone)
{
    ExplorerState state;
    state.preferences.workbenchPage = "planted";
    EXPECT_FALSE(workbenchIsOpen(state));
}

TEST(Workbench, ATabOpensItsPageAndClosesIt)
{
    Stage stage(900.0F, 40.0F);
    ExplorerState state = stateWithScene();
    const auto draw = [&] { stage.frameIn(corner, {900.0F, 40.0F}, [&] { drawWorkbenchTabs(state); }); };
    draw();
    const auto inFrame = [&] {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize({900.0F, 40.0F});
        ImGui::Begin("tabs", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawWorkbenchTabs(state);
        ImGui::End();
    };
    stage.click({20.0F, 20.0F}, inFrame);
    EXPECT_EQ(openPage(state), &workbenchPages().front());
    stage.click({20.0F, 20.0F}, inFrame);
    EXPECT_EQ(openPage(state), nullptr);
}

class EveryPage : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryPage, GivesEveryControlAnIdentityAndATooltip)
{
    Stage stage(benchSize.x, benchSize.y);
    ExplorerState state = stateWithScene();
    state.preferences.workbenchPage = workbenchPages()[GetParam()].id;
    const auto draw = [&] {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(benchSize);
        ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawWorkbench(state);
        ImGui::End();
    };
    const Faults faults = sweep(stage, corner, benchSize, {18.0F, 10.0F}, draw);
    EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
    EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
    EXPECT_GT(faults.controls, 0U);
}

std::string nameOfPage(const testing::TestParamInfo<std::size_t>& page)
{
    return workbenchPages()[page.param].id;
}

INSTANTIATE_TEST_SUITE_P(Workbench, EveryPage, testing::Range<std::size_t>(0, workbenchPages().size()), nameOfPage);

} // namespace
} // namespace reflectance::explorer
