// GL against double on a sparse grid: the bound holds on this driver for every model, and one wrong pixel breaks it.
#include "core/study/lens/gl_check.h"

#include "core/render/cpu/cpu_renderer.h"
#include "core/study/lens/sensitivity.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <cmath>
#include <limits>

namespace reflectance::test {
namespace {

constexpr RenderSettings settings{96, 80, 2};
constexpr std::size_t everyPixel = 96 * 80;

GlCheck checked(const ViewSamples& samples, const Image& drawn, const Scene& scene, std::size_t wanted = everyPixel)
{
    const Progress progress;
    return checkGl(samples, drawn, scene, wanted, progress).value();
}

class GlCheckTest : public GlTest {
protected:
    GlCheck checkedHere(const Scene& scene)
    {
        render(scene, settings);
        return checked(renderer().readSamples(), renderer().readLinear(), scene, everyPixel / 4);
    }
};

TEST_P(GlCheckTest, HoldsForEveryModelOnThisDriver)
{
    for (const Model& model : catalogue()) {
        Scene scene = twoLightScene(model.id());
        scene.lights.front().angularRadius = 12.0;
        const GlCheck check = checkedHere(scene);
        EXPECT_TRUE(check.holds()) << model.id() << ": " << check.worst.ratio << " of the bound at " << check.worst.x
                                   << ", " << check.worst.y;
        EXPECT_GT(check.pixels, 300U) << model.id();
    }
}

TEST_P(GlCheckTest, HoldsForSharpHighlightsAndSurroundings)
{
    Scene scene = twoLightScene("hybrid");
    scene.surface.values["n"] = {1e7};
    EXPECT_TRUE(checkedHere(scene).holds());
    scene.surface.model = "mirror";
    scene.environment.kind = EnvironmentKind::Studio;
    EXPECT_TRUE(checkedHere(scene).holds());
    scene.environment.kind = EnvironmentKind::Map;
    scene.environment.map = colorfulMap();
    EXPECT_TRUE(checkedHere(scene).holds());
}

/// The planted fault: a shader with K's rows and columns exchanged.
TEST_P(GlCheckTest, CatchesATransposedMatrix)
{
    Scene scene = twoLightScene("lambert_color");
    render(scene, settings);
    std::vector<double> K = valuesOf(scene);
    for (const auto& [i, j] : {std::pair{1U, 3U}, {2U, 6U}, {5U, 7U}})
        std::swap(K[i], K[j]);
    scene.surface.values["K"] = K;
    const GlCheck check = checked(renderer().readSamples(), renderer().readLinear(), scene);
    EXPECT_GT(check.beyond, 500U);
    EXPECT_GT(check.worst.ratio, 100.0);
}

IN_EVERY_CONTEXT(GlCheckTest);

struct Drawn {
    Scene scene = twoLightScene("hybrid");
    ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, settings);
    Image image = shadeSamples(samples, scene, Precision::Float);
};

TEST(GlCheckOfAPicture, FindsOneWrongPixel)
{
    Drawn drawn;
    ASSERT_TRUE(checked(drawn.samples, drawn.image, drawn.scene).holds());
    drawn.image.at(48, 40)[1] *= 1.001F; // three digits are left: the bound asks for four
    const GlCheck check = checked(drawn.samples, drawn.image, drawn.scene);
    EXPECT_EQ(check.beyond, 1U);
    EXPECT_EQ(check.worst.x, 48);
    EXPECT_EQ(check.worst.y, 40);
    EXPECT_NEAR(check.worst.difference, 0.001 * check.worst.exact.y, 1e-5 * check.worst.exact.y);
    EXPECT_EQ(check.worst.drawn.y, static_cast<double>(drawn.image.at(48, 40)[1]));
}

/// The far tail of a highlight, which shaders flush to 0, is no fault; light that is not there is one.
TEST(GlCheckOfAPicture, ForgivesATailThatWasFlushed)
{
    Drawn drawn;
    drawn.scene.surface.model = "phong";
    drawn.scene.surface.values["n"] = {3000.0};
    drawn.image = shadeSamples(drawn.samples, drawn.scene, Precision::Float);
    float* flushed = nullptr;
    for (std::size_t i = 0; i < drawn.image.rgb.size(); ++i)
        if (float& channel = drawn.image.rgb[i]; channel > 0.0F && channel < 1e-36F) {
            channel = 0.0F;
            flushed = drawn.image.coverage[i / 3] == 1.0F ? &channel : flushed;
        }
    ASSERT_NE(flushed, nullptr);
    EXPECT_TRUE(checked(drawn.samples, drawn.image, drawn.scene).holds());
    *flushed = 1e-30F;
    EXPECT_FALSE(checked(drawn.samples, drawn.image, drawn.scene).holds());
}

TEST(GlCheckOfAPicture, TakesNoNumberForInfinitelyWrong)
{
    Drawn drawn;
    drawn.image.at(50, 41)[2] = std::numeric_limits<float>::quiet_NaN();
    const GlCheck check = checked(drawn.samples, drawn.image, drawn.scene);
    EXPECT_EQ(check.beyond, 1U);
    EXPECT_EQ(check.worst.x, 50);
    EXPECT_TRUE(std::isinf(check.worst.ratio));
}

TEST(GlCheckOfAPicture, LooksAtAboutAsManyPixelsAsWanted)
{
    const Drawn drawn;
    const GlCheck sparse = checked(drawn.samples, drawn.image, drawn.scene, 300);
    EXPECT_GT(sparse.pixels, 50U) << "the object covers part of the picture";
    EXPECT_LE(sparse.pixels, 300U);
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(checkGl(drawn.samples, drawn.image, drawn.scene, 300, progress));
}

/// Lambert on a square, N = (0,0,1), L = (0.6,0,0.8): d(N.L)/dN is L, and kd moves the value by itself.
TEST(Sensitivities, OfLambertAreTheClosedForm)
{
    Scene scene = twoLightScene("lambert");
    scene.mesh = square();
    scene.camera.eye = {0, 0, 2};
    scene.lights.resize(1);
    scene.lights.front().direction = {0.6, 0, 0.8};
    scene.lights.front().intensity = {1, 1, 1};
    scene.surface.values["kd"] = {0.5};
    const Sensitivity found = sensitivityOf(sampleView(*makeRayScene(scene.mesh), scene.camera, {3, 3, 1}), scene);
    const std::size_t middle = found.value.size() / 2;
    // Pictures are float: differences of 1e-6 carry one part in 20 of rounding.
    EXPECT_NEAR(found.of[static_cast<int>(Input::Normal)][middle].x, 0.5 * 1.4, 0.1);
    EXPECT_NEAR(found.of[static_cast<int>(Input::Parameter)][middle].x, 0.4, 0.05);
    EXPECT_EQ(found.of[static_cast<int>(Input::Viewer)][middle].x, 0.0) << "Lambert does not see the viewer";
    // Turning L by its x tilts it by 0.8, its z by 0.6: 0.5 (0.6 0.8 + 0.36), and the intensity moves 0.4.
    EXPECT_NEAR(found.of[static_cast<int>(Input::Light)][middle].x, 0.5 * (0.48 + 0.36) + 0.4, 0.1);
}

} // namespace
} // namespace reflectance::test
