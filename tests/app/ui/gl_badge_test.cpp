// The badge is green within the bound and red beyond, names the pixel, and its ring can be clicked.
#include "app/explorer/ui/gl_badge.h"

#include "app/explorer/ui/lens_legend.h"
#include "app/explorer/ui/theme.h"
#include "core/render/cpu/cpu_renderer.h"
#include "tests/app/ui/stage.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

using testing::HasSubstr;

/// The state after a check of a picture in float; `wrong` is added to one of its pixels.
ExplorerState checkedState(float wrong)
{
    ExplorerState state;
    state.scene = defaultScene();
    state.renderer = "llvmpipe";
    const ViewSamples samples = sampleView(*makeRayScene(state.scene.mesh), state.scene.camera, {48, 48, 1});
    Image drawn = shadeSamples(samples, state.scene, Precision::Float);
    drawn.at(24, 24)[1] += wrong;
    const Progress progress;
    state.glCheck = checkGl(samples, drawn, state.scene, drawn.pixels(), progress);
    return state;
}

TEST(GlBadge, IsGreenWithinTheBound)
{
    const ExplorerState state = checkedState(0.0F);
    const Badge badge = badgeOf(state);
    EXPECT_EQ(badge.color, palette::good);
    EXPECT_THAT(badge.text, HasSubstr("GL = double to "));
    EXPECT_THAT(badge.about, HasSubstr("llvmpipe"));
    EXPECT_FALSE(worstPixelIsMarked(state));
}

TEST(GlBadge, TurnsRedWithOneWrongPixel)
{
    const ExplorerState state = checkedState(0.01F); // planted fault
    const Badge badge = badgeOf(state);
    EXPECT_EQ(badge.color, palette::error);
    EXPECT_EQ(badge.text, "GL differs from double at (24, 24)");
    EXPECT_TRUE(worstPixelIsMarked(state));
}

TEST(GlBadge, IsGreyWhileNothingIsKnown)
{
    EXPECT_EQ(badgeOf(ExplorerState()).color, palette::quiet);
    EXPECT_FALSE(worstPixelIsMarked(ExplorerState()));
}

TEST(GlBadge, AClickMarksTheWorstPixelAndAClickOnItSelectsIt)
{
    Stage stage(400.0F, 300.0F);
    ExplorerState state = checkedState(0.0F);
    const auto draw = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({400, 300});
        ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawGlBadge(state, {10, 10});
        if (worstPixelIsMarked(state))
            drawWorstPixel(state, {200, 150}, {0, 0}, {400, 300});
        ImGui::End();
    };
    stage.frame(draw);
    stage.click({30, 20}, draw);
    EXPECT_TRUE(worstPixelIsMarked(state));
    stage.click({200, 150}, draw);
    EXPECT_TRUE(state.worstPixelSelected);
    stage.click({200, 150}, draw);
    EXPECT_FALSE(state.worstPixelSelected);
    stage.click({30, 20}, draw);
    EXPECT_FALSE(worstPixelIsMarked(state));
}

TEST(LensSentence, SaysDigitsOrWhatThePixelIsMarkedFor)
{
    EXPECT_EQ(lensSentence(LensKind::Float, {LensMark::Digits, 3.7F}), "float keeps 3.7 of 7.2 digits.");
    EXPECT_THAT(lensSentence(LensKind::Half, {LensMark::Infinite, 0.0F}), HasSubstr("beyond the largest number"));
    EXPECT_THAT(lensSentence(LensKind::Simd, {}), HasSubstr("background"));
}

TEST(LensLegend, AClickChoosesTheArithmetic)
{
    Stage stage(400.0F, 300.0F);
    ExplorerState state;
    state.lens = LensKind::Float;
    state.lensFigures = LensFigures{100, 1, 2, 3, 4, 1.5, 6.0};
    const auto draw = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({400, 300});
        ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        drawLensLegend(state, {390, 290});
        ImGui::End();
    };
    stage.frame(draw);
    stage.frame(draw);
    // Four marks make the legend 180 points high; its first row begins 8 below its top.
    stage.click({360, 290 - 180 + 18}, draw);
    EXPECT_EQ(state.lens, LensKind::Glsl);
}

} // namespace
} // namespace reflectance::explorer
