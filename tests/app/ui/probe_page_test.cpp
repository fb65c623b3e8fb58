// The page of probes and what stands over the picture: every control explains itself, what is copied is the core's text.
#include "app/explorer/ui/probe_card.h"
#include "app/explorer/ui/workbench/probe_page.h"
#include "app/explorer/viewed_scene.h"
#include "tests/app/ui/sweep.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

const ImVec2 corner{0.0F, 0.0F};
constexpr ViewSize view{160, 120};

ExplorerState comparedState()
{
    ExplorerState state;
    state.scene = defaultScene();
    state.scene.lights[0].kind = LightKind::Point;
    state.scene.lights[0].position = {1.0, 1.0, 2.0};
    state.scene.other = state.scene.surface;
    state.scene.other->model = "phong";
    state.compare.on = true;
    probeUnder(state, {80.0, 60.0}, view);
    state.probe.pin(state.scene);
    probeUnder(state, {70.0, 40.0}, view);
    examine(state, state.scene, view);
    state.probe.foundLoose->pixelA =
        ProbedPixel{true, GlPixel{70, 40, {0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, 1e-8, 1e-6, 0.01}};
    state.probe.foundLoose->pixelB = ProbedPixel{false, {}};
    return state;
}

std::string clipboard()
{
    const char* text = ImGui::GetClipboardText();
    return text ? text : "";
}

class ProbePage : public testing::TestWithParam<float> {
protected:
    Stage::Draw drawn()
    {
        return [this] {
            ImGui::SetNextWindowPos(corner);
            ImGui::SetNextWindowSize(size);
            ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
            drawProbePage(state);
            ImGui::End();
        };
    }
    /// Clicks every place of the left column, each time on the page as it was at first, until it has happened.
    template <class Happened> void clickUntil(Happened happened)
    {
        const ExplorerState first = state;
        for (float y = 16.0F; y < size.y && !happened(); y += 12.0F)
            for (float x = 20.0F; x < 200.0F && !happened(); x += 60.0F) {
                state = first;
                stage.click({x, y}, drawn());
            }
        EXPECT_TRUE(happened());
    }

    ImVec2 size{GetParam(), 320.0F};
    Stage stage{size.x, size.y};
    ExplorerState state = comparedState();
};

TEST_P(ProbePage, ExplainsEveryControl)
{
    for (const ProbeDetail detail : {ProbeDetail::Point, ProbeDetail::Terms}) {
        state.probe.detail = detail;
        const Faults faults = sweep(stage, corner, size, {18.0F, 10.0F}, drawn());
        EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
        EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
        EXPECT_GT(faults.controls, 6U);
    }
}

TEST_P(ProbePage, CopiesTheCoresText)
{
    const std::string text = textOf(*state.probe.found());
    const std::string csv = probeCsv(listed(state.probe, state.scene));
    clickUntil([&] { return clipboard() == text; });
    clickUntil([&] { return clipboard() == csv; });
}

TEST_P(ProbePage, SavesTheTableAndShowsATermAlone)
{
    const std::string csv = probeCsv(listed(state.probe, state.scene));
    clickUntil([&] { return !state.requests.empty(); });
    EXPECT_EQ(state.requests[0].kind, Request::Kind::SaveText);
    EXPECT_EQ(state.requests[0].path, "probes.csv");
    EXPECT_EQ(state.requests[0].text, csv);
    state.probe.detail = ProbeDetail::Terms;
    clickUntil([&] { return state.probe.term == "specular"; });
}

TEST_P(ProbePage, SaysHowToBeginWhereNothingIsProbed)
{
    state.probe = {};
    const Faults faults = sweep(stage, corner, size, {18.0F, 10.0F}, drawn());
    EXPECT_TRUE(faults.silent.empty());
    EXPECT_GT(faults.controls, 4U);
}

INSTANTIATE_TEST_SUITE_P(Widths, ProbePage, testing::Values(430.0F, 1100.0F));

TEST(ProbeCard, OpensThePageAndPins)
{
    Stage stage(400.0F, 300.0F);
    ExplorerState state = comparedState();
    const auto draw = [&] {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize({400.0F, 300.0F});
        ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawProbeCard(state, corner, {400.0F, 300.0F});
        state.probe.term = "specular";
        drawTermBanner(state, {10.0F, 10.0F}, 300.0F);
        ImGui::End();
    };
    const Faults faults = sweep(stage, corner, {400.0F, 300.0F}, {8.0F, 8.0F}, draw);
    EXPECT_TRUE(faults.silent.empty());
    EXPECT_TRUE(faults.shared.empty());
    EXPECT_EQ(faults.controls, 3U) << "Formula, Pin, Show all";
    // From the right Pin comes first, from the left Formula.
    for (float x = 300.0F; x > 100.0F && state.probe.loose; x -= 8.0F)
        for (float y = 150.0F; y < 300.0F && state.probe.loose; y += 8.0F)
            stage.click({x, y}, draw);
    examine(state, state.scene, view); // as the frame loop does
    for (float x = 100.0F; x < 300.0F && state.preferences.workbenchPage.empty(); x += 8.0F)
        for (float y = 150.0F; y < 300.0F && state.preferences.workbenchPage.empty(); y += 8.0F)
            stage.click({x, y}, draw);
    EXPECT_EQ(state.scene.pins.size(), 2U);
    EXPECT_EQ(state.preferences.workbenchPage, "probe");
}

} // namespace
} // namespace reflectance::explorer
