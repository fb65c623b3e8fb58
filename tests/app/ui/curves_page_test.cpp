// The page of curves: every plot of it explains its controls, reads the core's numbers, and is saved in three forms.
#include "app/explorer/state.h"
#include "app/explorer/ui/lobe_plot.h"
#include "app/explorer/ui/savable_plot.h"
#include "app/explorer/ui/workbench/balls_view.h"
#include "app/explorer/ui/workbench/curves_page.h"
#include "core/math/angle.h"
#include "core/study/plots/lobes.h"
#include "tests/app/ui/sweep.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

const ImVec2 corner{0.0F, 0.0F};
const ImVec2 benchSize{900.0F, 320.0F};

class CurvesPageTest : public testing::TestWithParam<PlotTab> {
protected:
    CurvesPageTest()
    {
        state.scene = defaultScene();
        state.curves.tab = GetParam();
        answer();
    }

    void answer()
    {
        Progress progress;
        state.curves.answers[state.curves.tab] = *answered(questionOf(state), progress);
    }

    Stage::Draw drawn()
    {
        return [this] {
            ImGui::SetNextWindowPos(corner);
            ImGui::SetNextWindowSize(benchSize);
            ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
            drawCurvesPage(state);
            ImGui::End();
        };
    }

    Stage stage{benchSize.x, benchSize.y};
    ExplorerState state;
};

TEST_P(CurvesPageTest, GivesEveryControlAnIdentityAndATooltip)
{
    const Faults faults = sweep(stage, corner, benchSize, {22.0F, 9.0F}, drawn());
    EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
    EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
    EXPECT_GT(faults.controls, 7U);
}

TEST_P(CurvesPageTest, AsksForWhatTakesAWhileAndForNothingElse)
{
    stage.frame(drawn());
    const bool slow = GetParam() != PlotTab::Curves && GetParam() != PlotTab::Polar;
    EXPECT_EQ(state.curves.wish.has_value(), slow);
    if (slow) {
        EXPECT_EQ(*state.curves.wish, questionOf(state));
    }
}

/// Opens the menu in the plot's upper right corner again and again, and clicks down along its entries.
TEST_P(CurvesPageTest, SavesInThreeForms)
{
    stage.frame(drawn());
    for (float y = 64.0F; y < 140.0F; y += 6.0F) {
        stage.click({866.0F, 50.0F}, drawn());
        stage.click({850.0F, y}, drawn());
        stage.press(ImGuiKey_Escape, drawn());
    }
    bool svg = false, png = false, csv = false;
    for (const Request& request : state.requests) {
        svg = svg || (request.path.ends_with(".svg") && request.text.starts_with("<svg"));
        csv = csv || (request.path.ends_with(".csv") && request.text.find('\n') != std::string::npos);
        png = png || (request.kind == Request::Kind::SaveRegion && request.path.ends_with(".png"));
    }
    EXPECT_TRUE(svg);
    EXPECT_TRUE(png);
    EXPECT_TRUE(csv);
}

std::string nameOfTab(const testing::TestParamInfo<PlotTab>& tab)
{
    constexpr const char* names[] = {"curves", "polar", "lobe", "balls", "albedo", "wedge", "map"};
    return names[static_cast<int>(tab.param)];
}

INSTANTIATE_TEST_SUITE_P(, CurvesPageTest,
                         testing::Values(PlotTab::Curves, PlotTab::Polar, PlotTab::Lobe, PlotTab::Balls,
                                         PlotTab::Albedo, PlotTab::Wedge, PlotTab::Map),
                         nameOfTab);

NamedSurface phong()
{
    const Model& model = **findModel("phong");
    return {"Phong", seriesColor(0), &model, flatValues(model.text, {})};
}

TEST(LobePlot, ReadsTheCoresNumberAndTurnsWithADrag)
{
    Stage stage(400.0F, 400.0F);
    const CurveSettings settings{0.7};
    const LobeChart chart = *lobesOf({phong()}, settings, Progress());
    LobeView view;
    PlotHover hover;
    const auto draw = [&] {
        stage.frameIn(corner, {400.0F, 400.0F}, [&] { hover = drawLobes("lobe", chart, view, {380.0F, 380.0F}); });
    };
    for (float x = 100.0F; x < 360.0F && !hover.inside; x += 6.0F)
        for (float y = 60.0F; y < 240.0F && !hover.inside; y += 6.0F) {
            stage.moveTo({x, y});
            draw();
        }
    ASSERT_TRUE(hover.inside);
    const Vec3d V{std::sin(hover.x) * std::cos(hover.y), std::sin(hover.x) * std::sin(hover.y), std::cos(hover.x)};
    const auto ring =
        static_cast<std::size_t>(std::find(chart.theta.begin(), chart.theta.end(), hover.x) - chart.theta.begin());
    const auto column =
        static_cast<std::size_t>(std::find(chart.phi.begin(), chart.phi.end(), hover.y) - chart.phi.begin());
    ASSERT_LT(ring, chart.theta.size());
    EXPECT_EQ(chart.lobes[0].radius[chart.at(ring, column)], towards(phong(), settings, {&V, 1})[0]);

    const LobeView before = view;
    stage.hold(true);
    draw();
    stage.moveTo({ImGui::GetIO().MousePos.x + 40.0F, ImGui::GetIO().MousePos.y + 10.0F});
    draw();
    stage.hold(false);
    EXPECT_FALSE(view == before);
}

TEST(BallsView, ReadsFactorTimesLight)
{
    const NamedSurface surface = phong();
    const double tilt = radians(20.0);
    const Vec3d N{std::sin(tilt), 0.0, std::cos(tilt)};
    const Vec3d L{std::sin(2 * tilt), 0.0, std::cos(2 * tilt)}; // V is its mirror image: the peak, ks
    EXPECT_NEAR(radianceOf(surface, {{L, {1, 1, 1}, 0.0}}, N).x, surface.values[0], 1e-12);
    EXPECT_NEAR(radianceOf(surface, {{L, {1, 1, 1}, 0.0}, {L, {2, 1, 1}, 0.0}}, N).x, 3 * surface.values[0], 1e-12);
    EXPECT_EQ(radianceOf(surface, {}, N), Vec3d()) << "no light";
}

} // namespace
} // namespace reflectance::explorer
