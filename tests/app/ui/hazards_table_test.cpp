// The hazards' rows: sorted, sifted, explained, and a click shows the case.
#include "app/explorer/ui/workbench/hazards_table.h"

#include "app/explorer/ui/ui.h"
#include "tests/app/ui/sweep.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

using testing::ElementsAre;

const ImVec2 corner{0.0F, 0.0F};
const ImVec2 size{900.0F, 300.0F};

ExplorerState stateWithFindings()
{
    ExplorerState state;
    state.scene = defaultScene();
    state.preferences.workbenchPage = "extremes";
    for (const char* id : {"H01", "H04"})
        for (Finding& finding : runExtremes(programInstruments(nullptr, "no GL here"), id))
            state.extremes.findings.push_back(std::move(finding));
    state.extremes.findings[2].verdict = Verdict::Fail; // planted
    return state;
}

TEST(HazardsTable, KeepsTheOrderOfTheRunUnlessSorted)
{
    const std::vector<Finding> findings{{0, "H02", "b", "float", "", "", "", Verdict::Pass},
                                        {1, "H01", "c", "double", "", "", "", Verdict::Fail},
                                        {2, "H03", "a", "simd", "", "", "", Verdict::Pass}};
    EXPECT_THAT(shownFindings(findings, false, -1, false), ElementsAre(0U, 1U, 2U));
    EXPECT_THAT(shownFindings(findings, false, 0, false), ElementsAre(1U, 0U, 2U));
    EXPECT_THAT(shownFindings(findings, false, 1, true), ElementsAre(1U, 0U, 2U));
    EXPECT_THAT(shownFindings(findings, true, -1, false), ElementsAre(1U));
}

TEST(HazardsTable, AClickOnARowShowsItsCase)
{
    Stage stage(size.x, size.y);
    ExplorerState state = stateWithFindings();
    const auto draw = [&] {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawWorkbench(state);
        ImGui::End();
    };
    stage.frame(draw);
    stage.frame(draw);
    stage.click({300.0F, 90.0F}, draw);
    ASSERT_TRUE(state.extremesPage.selected);
    EXPECT_TRUE(state.putAside);
    EXPECT_EQ(state.scene.surface.model, "phong");
}

TEST(HazardsTable, EveryControlOfThePageIsExplained)
{
    for (const bool losses : {false, true}) {
        Stage stage(size.x, size.y);
        ExplorerState state = stateWithFindings();
        state.extremesPage.losses = losses;
        state.extremesPage.selected = 1;
        state.extremes.losses = {{"phong", "n at the peak", "float", 1e7, 1e3, std::nullopt}};
        const auto draw = [&] {
            ImGui::SetNextWindowPos(corner);
            ImGui::SetNextWindowSize(size);
            ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
            drawWorkbench(state);
            ImGui::End();
        };
        const Faults faults = sweep(stage, corner, {size.x - 16.0F, size.y}, {30.0F, 8.0F}, draw);
        EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
        EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip, the first at "
                                           << (faults.silent.empty() ? 0 : faults.silent[0].x) << ", "
                                           << (faults.silent.empty() ? 0 : faults.silent[0].y);
        EXPECT_GT(faults.controls, 4U);
    }
}

} // namespace
} // namespace reflectance::explorer
