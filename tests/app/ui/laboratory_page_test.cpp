// The page of the goniometer: a run is shown, explained and used, before it begins, while it goes and when it is done.
#include "app/explorer/ui/workbench/laboratory_page.h"
#include "tests/app/ui/sweep.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

std::shared_ptr<const LabRun> measuredRun()
{
    LabWish wish;
    wish.surface = "flat";
    wish.error = 1.0;
    LabLive live;
    Progress progress;
    EXPECT_TRUE(measuredAsWished(
        wish, nullptr, live, [] {}, progress));
    return live.latest();
}

Faults faultsOf(ExplorerState& state, ImVec2 size)
{
    const ImVec2 corner{0.0F, 0.0F};
    Stage stage(size.x, size.y);
    return sweep(stage, corner, size, {18.0F, 10.0F}, [&] {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawLaboratoryPage(state);
        ImGui::End();
    });
}

TEST(LaboratoryPage, ExplainsEveryControl)
{
    ExplorerState state;
    state.scene = defaultScene();
    state.lab.run = measuredRun();
    for (const bool running : {false, true}) {
        state.lab.running = running;
        const Faults faults = faultsOf(state, {900.0F, 420.0F});
        EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
        EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
        EXPECT_GT(faults.controls, 0U);
    }
}

TEST(LaboratoryPage, StandsBeforeTheFirstRunAndInASmallWindow)
{
    ExplorerState state;
    state.scene = defaultScene();
    state.lab.problem = "The micro-surface cannot be made.";
    EXPECT_TRUE(faultsOf(state, {600.0F, 260.0F}).silent.empty());
    state.lab.run = measuredRun();
    EXPECT_TRUE(faultsOf(state, {420.0F, 200.0F}).silent.empty());
}

} // namespace
} // namespace reflectance::explorer
