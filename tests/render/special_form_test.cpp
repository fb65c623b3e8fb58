// Pictures without the terms that are 0: equal to the general ones, by the CPU to the bit, by GL to rounding.
#include "core/render/cpu/cpu_renderer.h"
#include "core/scene/requirements.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <algorithm>
#include <cmath>

namespace reflectance::test {
namespace {

constexpr RenderSettings small{64, 64, 1};

struct Case {
    std::string model;
    ParameterValues values;
    std::string runs; ///< the start of the program's key
};

std::vector<Case> cases()
{
    return {{"hybrid", {}, "hybrid+one+"},
            {"hybrid", {{"ks", {0.0}}}, "lambert_color+directional"},
            {"hybrid", {{"K", {0.5, 0.25, 0.125}}}, "hybrid+diagonal+one+"},
            {"hybrid", {{"K", {0.5}}, {"ks", {0.1, 0.2, 0.3}}}, "hybrid+grey+directional"},
            {"hybrid", {{"ks", {0.0}}, {"K", {0.5}}}, "lambert+directional"},
            {"blinn_phong", {}, "blinn_phong+black+one+"},
            {"oren_nayar", {{"sigma", {0.0}}}, "lambert_color+diagonal+facing+"},
            {"oren_nayar", {{"sigma", {0.0}}, {"rho", {0.5}}}, "lambert+facing+"}};
}

Scene sceneOf(const Case& given)
{
    Scene scene = twoLightScene(given.model);
    scene.surface.values = given.values;
    return scene;
}

float worstDifference(const Image& a, const Image& b)
{
    float worst = 0.0F;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        worst = std::max(worst, std::fabs(a.rgb[i] - b.rgb[i]));
    return worst;
}

TEST(SpecialForms, OfTheCpuAreEqualInEveryPrecision)
{
    for (const Case& given : cases()) {
        const Scene scene = sceneOf(given);
        for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd}) {
            const Image general = renderOnCpu(scene, small, {precision, LobeForm::Conditioned, false});
            EXPECT_EQ(renderOnCpu(scene, small, precision).rgb, general.rgb) << given.runs << ' ' << nameOf(precision);
        }
    }
}

class GlSpecialForms : public GlTest {};

TEST_P(GlSpecialForms, ShowTheSamePicture)
{
    for (const Case& given : cases()) {
        const Scene scene = sceneOf(given);
        EXPECT_EQ(requirementsOf(scene).key().rfind(given.runs, 0), 0U) << requirementsOf(scene).key();
        render(scene, small);
        const Image special = renderer().readLinear();
        ASSERT_TRUE(renderer().render(scene, small, {Place::Sample, false, LobeForm::Conditioned, false}));
        // Compilers order products as they like: a few roundings of what the lights can give.
        EXPECT_LE(worstDifference(special, renderer().readLinear()), brightest(scene) * 8.0 * 0x1p-24) << given.runs;
    }
}

/// Dragging ks to 0 and back links a program once, and sees nothing anew.
TEST_P(GlSpecialForms, AreMadeWhenTheyAreMetAndKept)
{
    Scene scene = twoLightScene("hybrid");
    render(scene, small);
    const std::uint64_t before = renderer().work().programLinks;
    for (const double ks : {0.0, 0.3, 0.0, 0.2}) {
        scene.surface.values["ks"] = {ks};
        render(scene, small);
    }
    EXPECT_EQ(renderer().work().programLinks, before + 1);
    EXPECT_EQ(renderer().work().visibilities, 1U);
}

IN_EVERY_CONTEXT(GlSpecialForms);

} // namespace
} // namespace reflectance::test
