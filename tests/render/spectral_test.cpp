// The spectral picture against the patch's own integrals, and the cheats' prices on a picture.
#include "core/render/spectral/spectral_renderer.h"
#include "core/spectra/builtin.h"
#include "tests/render/sphere.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

constexpr RenderSettings tiny{24, 24, 1};

struct Bench {
    Scene scene;
    ViewSamples samples;
    ColorSystem system;
    JudgedSurface surface;
    JudgedLight FL11;

    [[nodiscard]] SpectralScene spectral(const JudgedLight* light) const
    {
        return *spectralScene(scene, system, surface, light);
    }
};

Bench benchFor(const std::string& model)
{
    Scene scene = sphereScene(model, 24);
    scene.lights[0].intensity = {0.9, 0.4, 0.2};
    scene.background.color = {0.1, 0.2, 0.3};
    Light second;
    second.kind = LightKind::Point;
    second.position = {-2, 1, 2};
    second.intensity = {0.1, 0.5, 2.0};
    scene.lights.push_back(second);
    AlsoOnGrid also;
    also.reflectances = {colorChecker()[14]};
    also.lights = {*lightNamed("FL11")};
    ColorSystem system = *makeColorSystem(*primariesNamed("E"), *sensorNamed("nikon_d5100"), also);
    ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, tiny);
    JudgedSurface surface = judgedSurface(system, also.reflectances[0]);
    JudgedLight light = judgedLight(system, also.lights[0]);
    return {std::move(scene), std::move(samples), std::move(system), std::move(surface), std::move(light)};
}

double largestDifference(const Image& a, const Image& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        largest = std::max(largest, std::fabs(double{a.rgb[i]} - double{b.rgb[i]}));
    return largest;
}

// Each wavelength's picture is rounded to float, as is the result: 6e-8 of values up to 1.
constexpr double rounding = 3e-7;

TEST(Spectral, TheFullKGivesTheSpectralPictureForLightsOfThePrimaries)
{
    for (const char* model : {"lambert_color", "hybrid"}) {
        const Bench bench = benchFor(model);
        const SpectralScene spectral = bench.spectral(nullptr);
        const Image truth = shadeSpectral(bench.samples, spectral, bench.system);
        const Scene byK = cheatScene(spectral, bench.system, bench.surface.K);
        EXPECT_LT(largestDifference(truth, shadeSamples(bench.samples, byK, Precision::Double)), rounding) << model;
        // The planted fault: the other convention's matrix.
        const Scene byM = cheatScene(spectral, bench.system, bench.surface.M);
        EXPECT_GT(largestDifference(truth, shadeSamples(bench.samples, byM, Precision::Double)), 1e-3) << model;
    }
}

TEST(Spectral, UnderAnyLightItIsTheIntegralTimesTheCosine)
{
    Bench bench = benchFor("lambert_color");
    bench.scene.lights.resize(1);
    bench.scene.lights[0].intensity = Vec3d(0.75);
    const Image truth = shadeSpectral(bench.samples, bench.spectral(&bench.FL11), bench.system);
    const Vec3d color = 0.75 * bench.system.response(bench.FL11.power, bench.surface.S);
    Scene cosine = bench.scene;
    cosine.surface.values["K"] = {color.x / 0.75, 0, 0, 0, color.y / 0.75, 0, 0, 0, color.z / 0.75};
    EXPECT_LT(largestDifference(truth, shadeSamples(bench.samples, cosine, Precision::Double)), rounding);
}

TEST(Spectral, PricesOnAPictureSayWhatThePatchSays)
{
    const Bench bench = benchFor("lambert_color");
    const auto prices =
        pricesOnPicture(bench.samples, bench.spectral(nullptr), bench.system, bench.surface, Vec3d(1.0));
    ASSERT_EQ(prices.size(), std::size(allCheats));
    // 3e-7 of white is at most 3e-7 * 903 * 5 in Lab at the dark end.
    EXPECT_LT(prices[0].max, 2e-3);
    EXPECT_EQ(prices[0].cheat, Cheat::FullK);
    for (std::size_t i = 1; i < prices.size(); ++i) {
        EXPECT_GT(prices[i].max, 0.1) << wordsFor(prices[i].cheat);
        EXPECT_LE(prices[i].mean, prices[i].max);
        EXPECT_LE(prices[i].p95, prices[i].max);
    }
    const auto lamp =
        pricesOnPicture(bench.samples, bench.spectral(&bench.FL11), bench.system, bench.surface, bench.FL11.white);
    EXPECT_GT(lamp[0].mean, 0.1) << "no K helps under a lamp that the primaries cannot make";
}

/// What a scene in the primary convention must show, put together from pictures that know no convention: M I (N.L) and
/// ks (W I) (R.V)^n.
TEST(Convention, ASceneInPrimariesIsDiffuseByMAndSpecularByW)
{
    const Bench bench = benchFor("hybrid");
    Scene primary = bench.scene;
    const auto M = rowByRow(bench.surface.M);
    const auto K = rowByRow(bench.surface.K);
    primary.background.color = {};
    primary.surface.values["K"] = {M.begin(), M.end()};
    primary.surface.values["ks"] = {0.25}; // named, for the models' defaults differ
    primary.surface.values["n"] = {40.0};
    Scene diffuse = primary;
    diffuse.surface.model = "lambert_color";
    Scene specular = primary;
    specular.surface.model = "phong";
    for (Light& light : specular.lights)
        light.intensity = bench.system.W * light.intensity;
    primary.surface.convention = Convention::Primary;
    primary.surface.W = rowByRow(bench.system.W);
    Scene sensor = specular; // lights as the sensor sees them
    sensor.surface.model = "hybrid";
    sensor.surface.values["K"] = {K.begin(), K.end()};

    const auto shaded = [&](const Scene& scene) { return shadeSamples(bench.samples, scene, Precision::Double); };
    const Image parts[] = {shaded(diffuse), shaded(specular)};
    const Image inPrimaries = shaded(primary);
    const Image inSensor = shaded(sensor);
    primary.surface.convention = Convention::Sensor;
    const Image wrong = shaded(primary);
    double worst = 0.0;
    for (std::size_t i = 0; i < inPrimaries.rgb.size(); ++i)
        worst =
            std::max(worst, std::fabs(double{parts[0].rgb[i]} + double{parts[1].rgb[i]} - double{inPrimaries.rgb[i]}));
    EXPECT_LT(worst, rounding);
    EXPECT_LT(largestDifference(inPrimaries, inSensor), rounding);
    EXPECT_GT(largestDifference(inPrimaries, wrong), 1e-2) << "the planted fault: the convention forgotten";
}

TEST(Spectral, AModelWithoutKIsRefused)
{
    Bench bench = benchFor("lambert_color");
    bench.scene.surface.model = "phong";
    const auto refused = spectralScene(bench.scene, bench.system, bench.surface, nullptr);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("no matrix K"), std::string::npos);
}

TEST(Spectral, AStopIsHeeded)
{
    const Bench bench = benchFor("lambert_color");
    Progress progress;
    progress.cancel = true;
    const Image image = shadeSpectral(bench.samples, bench.spectral(nullptr), bench.system, &progress);
    EXPECT_EQ(image.at(12, 12)[0], 0.0F) << "nothing but what needs no light";
}

} // namespace
} // namespace reflectance::test
