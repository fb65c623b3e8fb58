// The forms of the lobe in GLSL: what C++ computes, at directions and in a picture.
#include "core/reflectance/evaluate.h"
#include "core/render/cpu/cpu_renderer.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <algorithm>
#include <cmath>

namespace reflectance::test {
namespace {

std::vector<Observation> mirroredRows()
{
    std::vector<Observation> rows;
    for (int i = 0; i < 500; ++i) {
        const double angle = 1.6 * i / 500.0;
        rows.push_back({{0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}, {{{0, 0, 1}, {1, 1, 1}, 0.0}}});
    }
    return rows;
}

class GlLobe : public GlTest {
protected:
    /// Largest difference of GLSL in one form to double in another, over a lobe of exponent n.
    double worst(LobeForm inGl, LobeForm inDouble, double n)
    {
        const Model& phong = **findModel("phong");
        const std::vector<double> values = flatValues(phong.text, {{"ks", {1.0}}, {"n", {n}}});
        const auto rows = mirroredRows();
        const auto truth = evaluate(phong, values, rows, {Precision::Double, inDouble});
        const auto got = renderer().evaluate(phong, values, rows, nullptr, inGl);
        EXPECT_TRUE(got) << got.error().sentence();
        double difference = 0.0;
        for (std::size_t i = 0; got && i < rows.size(); ++i)
            difference = std::fmax(difference, std::fabs(got.value()[i].x - truth[i].x));
        return difference;
    }
};

/// The dot product and each multiplication round to 2^-24, pow of llvmpipe to a few units, and n multiplies what they lose.
double rounding(double n)
{
    return 4.0 * (n + 4.0) * 0x1p-24;
}

TEST_P(GlLobe, EveryFormIsThatOfTheCore)
{
    for (const LobeFormFacts& facts : lobeForms())
        for (const double n : {1.0, 2.0, 8.0, 64.0, 200.0})
            EXPECT_LE(worst(facts.form, facts.form, n), rounding(n)) << facts.name << ' ' << n;
}

/// The planted fault: one form taken for another.
TEST_P(GlLobe, TellsTheFormsApart)
{
    EXPECT_GT(worst(LobeForm::Schlick, LobeForm::Conditioned, 64.0), 10.0 * rounding(64.0));
    EXPECT_GT(worst(LobeForm::Table, LobeForm::Truncated, 64.0), 10.0 * rounding(64.0));
}

/// The same samples in both renderers; two lights, whose highlights are at most 0.25 each.
TEST_P(GlLobe, PicturesShowTheFormThatIsAskedFor)
{
    Scene scene = twoLightScene("hybrid");
    scene.surface.values["n"] = {32.0};
    constexpr RenderSettings settings{64, 64, 1};
    for (const LobeFormFacts& facts : lobeForms()) {
        ASSERT_TRUE(renderer().render(scene, settings, {Place::Sample, false, facts.form}));
        const Image picture = renderer().readLinear();
        const Image truth = shadeSamples(renderer().readSamples(), scene, {Precision::Double, facts.form});
        float worst = 0.0F;
        for (std::size_t i = 0; i < picture.rgb.size(); ++i)
            worst = std::max(worst, std::fabs(picture.rgb[i] - truth.rgb[i]));
        EXPECT_LE(worst, brightest(scene) * rounding(32.0)) << facts.name;
    }
    EXPECT_EQ(renderer().work().visibilities, 1U); // a form is a matter of shading alone
}

/// A model without a lobe is drawn by one program, whatever is asked for.
TEST_P(GlLobe, ChangesNothingWithoutALobe)
{
    const Scene scene = twoLightScene("lambert");
    for (const LobeFormFacts& facts : lobeForms())
        ASSERT_TRUE(renderer().render(scene, {32, 32, 1}, {Place::Sample, false, facts.form}));
    EXPECT_EQ(renderer().work().shadings, 1U);
}

IN_EVERY_CONTEXT(GlLobe);

} // namespace
} // namespace reflectance::test
