// What lies over the picture while A and B are compared: every control has an identity and a tooltip, clicks do what they
// say, and the figures are put into plain words.
#include "app/explorer/ui/compare_overlay.h"

#include "app/explorer/ui/ui.h"
#include "tests/app/ui/sweep.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

using testing::HasSubstr;
using testing::Not;

const Area picture{0, 0, 760, 500};

ExplorerState comparing(CompareMode mode)
{
    ExplorerState state;
    state.scene = defaultScene();
    toggleCompare(state.compare, state.scene);
    state.scene.other->model = "oren_nayar";
    state.compare.mode = mode;
    state.compare.scale = 0.05;
    return state;
}

void drawOverlay(ExplorerState& state)
{
    ImGui::SetNextWindowPos({picture.x, picture.y});
    ImGui::SetNextWindowSize({picture.width, picture.height});
    ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    drawCompareOverlay(state, picture, panesOf(state.compare, picture, 1));
    ImGui::End();
}

class EveryMode : public testing::TestWithParam<CompareMode> {};

TEST_P(EveryMode, GivesEveryControlAnIdentityAndATooltip)
{
    Stage stage(picture.width, picture.height);
    ExplorerState state = comparing(GetParam());
    const Faults faults = sweep(stage, {0, 0}, {picture.width, picture.height}, {12, 8}, [&] { drawOverlay(state); });
    EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
    EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
    EXPECT_GE(faults.controls, 6U) << "four modes and two names";
}

INSTANTIATE_TEST_SUITE_P(Compare, EveryMode,
                         testing::Values(CompareMode::SideBySide, CompareMode::Wipe, CompareMode::Flip,
                                         CompareMode::Difference));

TEST(CompareOverlay, DrawsNothingWhileNothingIsCompared)
{
    Stage stage(picture.width, picture.height);
    ExplorerState state = comparing(CompareMode::Wipe);
    toggleCompare(state.compare, state.scene);
    const Faults faults = sweep(stage, {0, 0}, {picture.width, picture.height}, {40, 20}, [&] { drawOverlay(state); });
    EXPECT_EQ(faults.controls, 0U);
}

TEST(CompareOverlay, TheDividerFollowsTheHand)
{
    Stage stage(picture.width, picture.height);
    ExplorerState state = comparing(CompareMode::Wipe);
    const auto draw = [&] { drawOverlay(state); };
    stage.moveTo({picture.width / 2, 250});
    stage.frame(draw);
    stage.hold(true);
    stage.frame(draw);
    stage.moveTo({picture.width / 4, 250});
    stage.frame(draw);
    EXPECT_TRUE(state.compare.holdsDivider);
    stage.hold(false);
    stage.frame(draw);
    EXPECT_NEAR(state.compare.divider, 0.25F, 0.02F); // the hand takes it within a few points
}

TEST(CompareOverlay, SaysInWordsWhatIsExactlyZero)
{
    EXPECT_THAT(figuresText(std::nullopt), HasSubstr("measuring"));
    DifferenceFigures figures{true, 10, 0.0, 0.0, 0.0, 0.0, 0.0};
    EXPECT_THAT(figuresText(figures), HasSubstr("exactly equal"));
    figures.pixels = 0;
    EXPECT_THAT(figuresText(figures), HasSubstr("nothing to compare"));
    figures = {false, 10, 0.0123, 0.5, std::nullopt, std::nullopt, std::nullopt};
    EXPECT_THAT(figuresText(figures), HasSubstr("RMSE 0.0123, largest 0.5"));
    EXPECT_THAT(figuresText(figures), Not(HasSubstr("dE2000"))) << "not measured yet";
    figures.deltaEP95 = 12.0;
    figures.deltaEMax = 20.0;
    EXPECT_THAT(figuresText(figures), HasSubstr("dE2000 p95 12, largest 20"));
}

TEST(VariantSwitch, StandsInTheSurfacePanelWhileComparing)
{
    Stage stage(360, 1300);
    ExplorerState state = comparing(CompareMode::SideBySide);
    const auto draw = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({360, 1300});
        ImGui::Begin("panels", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawPanels(state);
        ImGui::End();
    };
    for (const bool onB : {false, true}) {
        state.compare.handOnB = onB;
        const Faults faults = sweep(stage, {0, 0}, {360, 1300}, {18, 10}, draw);
        EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
        EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
    }
}

} // namespace
} // namespace reflectance::explorer
