// The stability lens: digits as closed forms give them, marks where they belong, and the guilty term by name.
#include "core/study/lens/lens.h"

#include "core/render/cpu/cpu_renderer.h"
#include "core/study/lens/half.h"
#include "core/study/lens/palette.h"
#include "core/study/lens/term.h"
#include "tests/render/gl_scenes.h"
#include "tests/render/sphere.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

namespace reflectance::test {
namespace {

using testing::HasSubstr;

constexpr RenderSettings settings{65, 65, 1};

/// A view under the lens.
struct Looked {
    ViewSamples samples;
    Image image;
    LensMap map;

    [[nodiscard]] LensReading at(LensKind kind, const Scene& scene, int x, int y) const
    {
        return readingAt(kind, map, samples, image, scene, x, y);
    }
};

Looked looked(LensKind kind, const Scene& scene)
{
    Progress progress;
    Looked view;
    view.samples = sampleView(*makeRayScene(scene.mesh), scene.camera, settings);
    view.image = shadedFor(kind, view.samples, scene);
    view.map = lensMap(kind, view.samples, view.image, scene, progress).value();
    return view;
}

/// A square in z = 0, seen straight on under a light from (0.6, 0, 0.8): N.L = 0.8 everywhere.
Scene squareScene(const std::string& model)
{
    Scene scene = sphereScene(model);
    scene.mesh = square();
    scene.camera.eye = {0, 0, 2};
    scene.lights.front().direction = {0.6, 0, 0.8};
    return scene;
}

TEST(Lens, CountsDigits)
{
    EXPECT_NEAR(digitsKept(2.0, 2.002, 7.2), 3.0, 1e-9);
    EXPECT_NEAR(digitsKept(-2.0, -1.98, 7.2), 2.0, 1e-9);
    EXPECT_EQ(digitsKept(1.0, 1.0, 7.2), 7.2);
    EXPECT_EQ(digitsKept(1.0, 1.0 + 1e-12, 7.2), 7.2) << "no more than the arithmetic has";
    EXPECT_EQ(digitsKept(1.0, -1.0, 7.2), 0.0);
    EXPECT_EQ(digitsKept(0.0, 1e-9, 7.2), 0.0) << "of an exact 0 nothing else keeps a digit";
    EXPECT_EQ(digitsKept(1e-300, 0.0, 7.2), 7.2) << "below the smallest normal float all is 0";
    EXPECT_EQ(digitsKept(1.0, NAN, 7.2), 0.0);
    EXPECT_EQ(digitsKept(1.0, INFINITY, 7.2), 0.0);
}

TEST(Lens, RoundsToHalfAsIeeeDoes)
{
    EXPECT_EQ(roundedToHalf(1.0F / 3.0F), 0.333251953125F);
    EXPECT_EQ(roundedToHalf(1.0F + 0x1p-11F), 1.0F) << "a tie goes to the even neighbour";
    EXPECT_EQ(roundedToHalf(1.0F + 3.0F * 0x1p-11F), 1.0F + 0x1p-9F) << "here it lies above";
    EXPECT_EQ(roundedToHalf(65519.0F), 65504.0F);
    EXPECT_EQ(roundedToHalf(-65520.0F), -INFINITY);
    EXPECT_EQ(roundedToHalf(0x1p-24F), 0x1p-24F);
    EXPECT_EQ(roundedToHalf(0x1p-25F), 0.0F);
    EXPECT_TRUE(std::isnan(roundedToHalf(NAN)));
}

/// Where (R.V)^n = v, kappa is n tan(d) - log v with d^2 = -2 log(v) / n: float may lose that, and at the flank does.
TEST(Lens, ASharpHighlightLosesDigitsAtItsFlank)
{
    Scene scene = squareScene("phong");
    scene.camera.eye = {0, -1.2, 1.6};
    scene.camera.fieldOfView = 1.0;
    scene.lights.front().direction = {0, 0.6, 0.8};
    scene.surface.values = {{"ks", {1.0}}, {"n", {1e7}}};
    const Looked view = looked(LensKind::Float, scene);
    const Image exact = shadeSamples(view.samples, scene, Precision::Double);
    double fewest = 10.0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < view.map.pixels.size(); ++i) {
        const double value = exact.rgb[3 * i];
        if (value < 1e-30)
            continue;
        const double kappa = std::sqrt(-2.0 * std::log(value) * 1e7) - std::log(value);
        EXPECT_GE(view.map.pixels[i].digits, -std::log10(32.0 * (kappa + 1.0) * 0x1p-24)) << value;
        worst = view.map.pixels[i].digits < fewest ? i : worst;
        fewest = std::min<double>(fewest, view.map.pixels[i].digits);
    }
    EXPECT_GT(view.map.at(32, 32).digits, 6.0F) << "the peak itself is exact";
    EXPECT_LT(fewest, 4.5) << "half of the peak has kappa 3700: 3.7 digits, up or down by luck";
    const LensReading flank =
        view.at(LensKind::Float, scene, static_cast<int>(worst % 65), static_cast<int>(worst / 65));
    EXPECT_THAT(flank.term, HasSubstr("n = 1e+07: the lobe"));
    EXPECT_THAT(flank.term, HasSubstr("R.V = "));
    EXPECT_GT(flank.kappa, 100.0);
}

/// K's first row leaves 0.1 of 1000.1: float rounds the larger number and that is all that happens.
TEST(Lens, CancellationInKIsNamed)
{
    Scene scene = squareScene("lambert_color");
    scene.surface.values["K"] = {1000.1, -1000, 0, 0, 0.5, 0, 0, 0, 0.5};
    const Looked view = looked(LensKind::Float, scene);
    const double left = static_cast<double>(1000.1F) - 1000.0;
    const double expected = -std::log10(std::fabs(left - 0.1) / 0.1);
    // N.L takes part with a few units of 6e-8, far below.
    EXPECT_NEAR(view.map.at(32, 32).digits, expected, 0.01);
    EXPECT_THAT(view.at(LensKind::Float, scene, 32, 32).term,
                HasSubstr("cancellation in K I, row 1: 2e+03 leaves 0.1"));
}

TEST(Lens, TheHorizonIsNamed)
{
    Scene scene = squareScene("lambert");
    scene.lights.front().direction = {1, 0, 1e-4};
    EXPECT_THAT(looked(LensKind::Float, scene).at(LensKind::Float, scene, 32, 32).term, HasSubstr("nothing but a few"))
        << "N = (0,0,1) gives the cosine without a sum";
    scene.mesh = sphereMesh(64);
    scene.camera.eye = {0, 0, 4};
    scene.lights.front().direction = {-0.7, -0.6, std::sqrt(1.0 - 0.85) * 1e-3};
    const Looked view = looked(LensKind::Float, scene);
    std::size_t named = 0;
    for (int x = 0; x < 65; ++x)
        for (int y = 0; y < 65; ++y) {
            const LensReading reading = view.at(LensKind::Float, scene, x, y);
            named += reading.kappa > 20.0 && reading.term.find("horizon") != std::string::npos ? 1 : 0;
        }
    EXPECT_GT(named, 10U) << "along the terminator";
}

TEST(Lens, WhatIsWellConditionedAccusesNobody)
{
    const Scene scene = squareScene("hybrid");
    const Looked view = looked(LensKind::Float, scene);
    const LensReading reading = view.at(LensKind::Float, scene, 32, 32);
    EXPECT_EQ(reading.term, "nothing but a few roundings");
    EXPECT_GT(reading.pixel.digits, 6.0F);
    EXPECT_NEAR(reading.got.x, reading.exact.x, 1e-6);
}

TEST(Lens, HalfEndsAt65504AndThinsOutBelow)
{
    Scene scene = squareScene("lambert");
    scene.surface.values["kd"] = {1.0};
    scene.lights.front().intensity = Vec3d(1e5);
    EXPECT_EQ(looked(LensKind::Half, scene).map.at(32, 32).mark, LensMark::Infinite);
    EXPECT_THAT(looked(LensKind::Half, scene).at(LensKind::Half, scene, 32, 32).term, HasSubstr("65504"));
    scene.lights.front().intensity = Vec3d(1e-7); // 8e-8 between steps of 6e-8
    const Looked dark = looked(LensKind::Half, scene);
    EXPECT_LT(dark.map.at(32, 32).digits, 1.0F);
    EXPECT_THAT(dark.at(LensKind::Half, scene, 32, 32).term, HasSubstr("lose bits"));
    scene.lights.front().intensity = Vec3d(1.0);
    EXPECT_GE(looked(LensKind::Half, scene).map.at(32, 32).digits, 3.3F);
    EXPECT_EQ(looked(LensKind::Float, scene).map.at(32, 32).mark, LensMark::Digits);
}

TEST(Lens, ASurfaceThatSendsOnMoreThanArrivesIsMarked)
{
    Scene scene = squareScene("lambert");
    scene.surface.values["kd"] = {0.9};
    EXPECT_EQ(looked(LensKind::Float, scene).map.at(32, 32).mark, LensMark::Digits);
    scene.surface.values["kd"] = {1.1};
    EXPECT_EQ(looked(LensKind::Float, scene).map.at(32, 32).mark, LensMark::AbovePassive);
}

/// The planted faults: one pixel each.
TEST(Lens, MarksWhatIsWrongInAPicture)
{
    const Scene scene = squareScene("hybrid");
    Looked view = looked(LensKind::Glsl, scene);
    view.image.at(30, 30)[0] = NAN;
    view.image.at(31, 30)[1] = INFINITY;
    view.image.at(32, 30)[2] = -0.1F;
    view.image.at(33, 30)[0] *= 1.01F;
    Progress progress;
    const LensMap map = lensMap(LensKind::Glsl, view.samples, view.image, scene, progress).value();
    EXPECT_EQ(map.at(30, 30).mark, LensMark::NotANumber);
    EXPECT_EQ(map.at(31, 30).mark, LensMark::Infinite);
    EXPECT_EQ(map.at(32, 30).mark, LensMark::Negative);
    EXPECT_EQ(map.at(33, 30).mark, LensMark::Digits);
    EXPECT_NEAR(map.at(33, 30).digits, 2.0, 1e-3);
    EXPECT_EQ(map.at(0, 0).mark, LensMark::Background);
    const LensFigures figures = figuresOf(map);
    EXPECT_EQ(figures.notANumber, 1U);
    EXPECT_EQ(figures.infinite, 1U);
    EXPECT_EQ(figures.negative, 1U);
    EXPECT_NEAR(figures.fewest, 2.0, 1e-3);
    EXPECT_GT(figures.median, 6.0);
}

TEST(Lens, IsGivenUpWhenCancelled)
{
    const Scene scene = squareScene("hybrid");
    const Looked view = looked(LensKind::Float, scene);
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(lensMap(LensKind::Float, view.samples, view.image, scene, progress));
}

double lightness(const Rgb8& color)
{
    return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

TEST(LensPalette, DarkensWithEveryDigitForEveryEye)
{
    for (int tenth = 1; tenth <= 70; ++tenth)
        EXPECT_LT(lightness(colorOfDigits(0.1 * tenth)), lightness(colorOfDigits(0.1 * (tenth - 1)))) << tenth;
}

TEST(LensPalette, HatchesMarksButNotDigits)
{
    for (const LensLegend& line : lensLegend()) {
        std::size_t black = 0;
        for (int x = 0; x < 20; ++x)
            black += colorOf({line.mark, 3.0F}, x, 0) == Rgb8{0, 0, 0} ? 1 : 0;
        EXPECT_EQ(black, 4U) << line.name;
    }
    for (int x = 0; x < 20; ++x)
        EXPECT_EQ((colorOf({LensMark::Digits, 3.0F}, x, 0)), colorOfDigits(3.0));
}

} // namespace
} // namespace reflectance::test
