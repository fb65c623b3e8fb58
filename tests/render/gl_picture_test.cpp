// GL's picture against double on the very samples that GL shaded: what is left is float arithmetic.
#include "core/render/cpu/cpu_renderer.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <algorithm>
#include <cmath>

namespace reflectance::test {
namespace {

constexpr double eps = 0x1p-24;

double largestDifference(const Image& a, const Image& b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const double difference = std::fabs(static_cast<double>(a.rgb[i]) - b.rgb[i]);
        worst = difference <= worst ? worst : difference; // NaN wins
    }
    return worst;
}

class GlPicture : public GlTest {
protected:
    double errorAgainstDouble(const Scene& scene, const RenderSettings& settings)
    {
        render(scene, settings);
        const Image truth = shadeSamples(renderer().readSamples(), scene, Precision::Double);
        const Image picture = renderer().readLinear();
        EXPECT_EQ(picture.coverage, truth.coverage);
        EXPECT_GT(*std::max_element(truth.rgb.begin(), truth.rgb.end()), 0.1F) << "a black picture proves nothing";
        return largestDifference(picture, truth);
    }
};

/// L and V are off by 3 eps after their square roots, R by 6, so the lobe's x by 9 eps |R-V|; its value moves by
/// n |R-V| exp(-n |R-V|^2 / 2) times that, at most sqrt(n/e) times. The rest is a dozen roundings. Together below
/// (16 + 9 sqrt(n)) eps of the light that arrives.
double floatBound(const Scene& scene, double n)
{
    return (16.0 + 9.0 * std::sqrt(n)) * eps * brightest(scene);
}

TEST_P(GlPicture, EqualsDoubleOnItsOwnSamples)
{
    for (const char* model : {"lambert", "lambert_color", "phong", "hybrid"})
        for (const int samples : {1, 2, 3}) {
            const Scene scene = twoLightScene(model);
            EXPECT_LE(errorAgainstDouble(scene, {96, 80, samples}), floatBound(scene, 40.0)) << model << ' ' << samples;
        }
}

/// Through a lens of 1 degree, onto the mirrored light on a flat square: at n = 1e7 the highlight is 10 pixels wide.
TEST_P(GlPicture, HoldsForSharpHighlights)
{
    Scene scene = twoLightScene("phong");
    scene.mesh = square();
    scene.camera.eye = {0, -1.2, 1.6};
    scene.camera.fieldOfView = 1.0;
    scene.lights.pop_back();
    scene.lights[0].direction = {0, 0.6, 0.8};
    for (const double n : {0.0, 1.0, 1e3, 1e5, 1e7}) {
        scene.surface.values["n"] = {n};
        EXPECT_LE(errorAgainstDouble(scene, {256, 256, 1}), floatBound(scene, n)) << n;
    }
}

TEST_P(GlPicture, TheBoundCatchesATransposedMatrix)
{
    Scene scene = twoLightScene("lambert_color");
    render(scene, {96, 80, 1});
    const Image picture = renderer().readLinear();
    std::vector<double> K = valuesOf(scene);
    for (const auto& [i, j] : {std::pair{1U, 3U}, {2U, 6U}, {5U, 7U}})
        std::swap(K[i], K[j]);
    scene.surface.values["K"] = K;
    const Image transposed = shadeSamples(renderer().readSamples(), scene, Precision::Double);
    EXPECT_GT(largestDifference(picture, transposed), 10.0 * floatBound(scene, 0.0));
}

TEST_P(GlPicture, AMirrorShowsEverySurrounding)
{
    Scene scene = twoLightScene("mirror");
    scene.environment.radiance = {1.0, 0.8, 0.6};
    scene.environment.rotation = 33.0;
    scene.environment.map = colorfulMap();
    scene.background.kind = BackgroundKind::Environment;
    // The steepest place of the studio is a lamp's soft edge, 6 units of radiance over 0.05 rad; of the map, 1 unit from
    // one texel to the next, 0.1 rad. The reflected direction is off by 10 eps, the map's angles by 5e-7.
    for (const auto& [kind, bound] : {std::pair{EnvironmentKind::Constant, 16.0 * eps},
                                      std::pair{EnvironmentKind::Studio, 2.0 * 6.0 / 0.05 * 10.0 * eps},
                                      std::pair{EnvironmentKind::Map, 1.0 / 0.1 * 2e-6}}) {
        scene.environment.kind = kind;
        EXPECT_LE(errorAgainstDouble(scene, {128, 96, 2}), bound) << static_cast<int>(kind);
    }
}

TEST_P(GlPicture, AMirrorShowsALightAsADisc)
{
    Scene scene = twoLightScene("mirror");
    scene.background.color = {0, 0, 0};
    scene.lights[0].angularRadius = 12.0;
    scene.lights[1].on = false;
    render(scene, {128, 128, 2});
    const Image picture = renderer().readLinear();
    const Image truth = shadeSamples(renderer().readSamples(), scene, Precision::Double);
    std::size_t bright = 0;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < truth.rgb.size(); i += 3) {
        bright += truth.rgb[i] > 0.0F ? 1U : 0U;
        differing += std::fabs(truth.rgb[i] - picture.rgb[i]) > 1e-6F ? 1U : 0U;
    }
    EXPECT_GT(bright, 20U);
    EXPECT_LE(differing, 1U) << "only a sample within 1e-6 rad of the disc's rim may fall on the other side";
    scene.lights[0].angularRadius = 0.0;
    render(scene, {128, 128, 2});
    const Image dark = renderer().readLinear();
    EXPECT_EQ(*std::max_element(dark.rgb.begin(), dark.rgb.end()), 0.0F) << "a point in a mirror is met by no ray";
}

TEST_P(GlPicture, ASquareUnderOneLightIsTheClosedForm)
{
    Scene scene = twoLightScene("lambert");
    scene.mesh = square();
    scene.lights.pop_back();
    scene.lights[0].direction = {0, 3, 4};
    scene.surface.values["kd"] = {0.5};
    scene.camera.eye = {0, 0, 2};
    render(scene, {33, 33, 1});
    const Image picture = renderer().readLinear();
    EXPECT_FLOAT_EQ(picture.at(16, 16)[0], 0.5F * 0.8F * 1.0F);
    EXPECT_FLOAT_EQ(picture.at(16, 16)[1], 0.5F * 0.8F * 0.8F);
    EXPECT_FLOAT_EQ(picture.at(0, 0)[2], static_cast<float>(scene.background.color.z));
}

TEST_P(GlPicture, BackFacesAreSeenFromTheirSide)
{
    Scene scene = twoLightScene("lambert");
    scene.mesh = square();
    scene.lights.pop_back();
    scene.lights[0].direction = {0, 0, -1};
    scene.camera.eye = {0, 0, -2};
    render(scene, {33, 33, 1});
    EXPECT_FLOAT_EQ(renderer().readLinear().at(16, 16)[0], 0.8F);
}

TEST_P(GlPicture, ManyLightsAddUp)
{
    Scene scene = twoLightScene("lambert");
    const Light one = scene.lights[0];
    scene.lights.assign(1024, one);
    for (Light& light : scene.lights)
        light.intensity = one.intensity / 1024.0;
    Scene single = scene;
    single.lights = {one};
    render(single, {32, 32, 1});
    const Image once = renderer().readLinear();
    render(scene, {32, 32, 1});
    const double bound = 1024.0 * eps; // hazard H42: N eps of the sum
    EXPECT_LE(largestDifference(renderer().readLinear(), once), bound);
}

TEST_P(GlPicture, AnEmptyMeshShowsTheBackground)
{
    Scene scene = twoLightScene("hybrid");
    scene.mesh = std::make_shared<Mesh>();
    render(scene, {8, 8, 2});
    const Image picture = renderer().readLinear();
    EXPECT_EQ(picture.coverage, std::vector<float>(64, 0.0F));
    EXPECT_EQ(renderer().readSamples().count(), 0U);
    EXPECT_FLOAT_EQ(picture.rgb[1], static_cast<float>(scene.background.color.y));
}

IN_EVERY_CONTEXT(GlPicture);

} // namespace
} // namespace reflectance::test
