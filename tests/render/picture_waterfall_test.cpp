// From the truth to the picture, cause by cause: each cause alone takes the whole share, and all of them add up.
#include "core/render/pictures/picture_waterfall.h"

#include "core/render/cpu/cpu_renderer.h"
#include "core/sensor/fields.h"
#include "tests/render/gl_scenes.h"

#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

constexpr RenderSettings settings{48, 32, 2};

/// Nothing but exposure, and so dark that nothing clips: linear values in 16 bits.
Scene plainScene(int rings = 48)
{
    Scene scene = twoLightScene("hybrid", rings);
    for (Light& light : scene.lights)
        light.intensity = light.intensity * 0.2;
    EXPECT_TRUE(setOnSensor("all=off", scene.sensor));
    return scene;
}

Waterfall waterfallTo(const Scene& scene, const Scene& truth, Precision precision = Precision::Double)
{
    const Image rendered = renderOnCpu(scene, settings, precision);
    const auto waterfall = waterfallOf(picturesToTruth(scene, truth, settings, rendered));
    EXPECT_TRUE(waterfall) << waterfall.error().sentence();
    return *waterfall;
}

double shareOf(const Waterfall& waterfall, const std::string& step)
{
    for (const WaterfallStep& one : waterfall.steps)
        if (one.step == step)
            return one.share;
    ADD_FAILURE() << "no step " << step;
    return 0.0;
}

TEST(PictureWaterfall, StepsStandInTheOrderOfTheLight)
{
    const Waterfall waterfall = waterfallTo(plainScene(), plainScene());
    std::string order;
    for (const WaterfallStep& step : waterfall.steps)
        order += step.step + " ";
    EXPECT_EQ(order, "geometry model precision sensor encoding ");
}

TEST(PictureWaterfall, NothingIsLostButTheFilesSixteenBits)
{
    const Scene scene = plainScene();
    const Waterfall waterfall = waterfallTo(scene, scene);
    for (const char* step : {"geometry", "model", "precision", "sensor"})
        EXPECT_EQ(shareOf(waterfall, step), 0.0) << step;
    EXPECT_LE(waterfall.maxAbs, 0.5 / 65535.0 + 1e-7);
}

TEST(PictureWaterfall, EachCauseTakesTheShareThatItIsDue)
{
    const Scene truth = plainScene();
    Scene coarse = plainScene(6);
    EXPECT_GT(shareOf(waterfallTo(coarse, truth), "geometry"), 0.999);
    Scene other = truth;
    other.surface.values["ks"] = {0.1};
    EXPECT_GT(shareOf(waterfallTo(other, truth), "model"), 0.999);
    Scene noisy = truth;
    ASSERT_TRUE(setOnSensor("noise=100:full_well=1000", noisy.sensor));
    EXPECT_GT(shareOf(waterfallTo(noisy, truth), "sensor"), 0.95);
    Scene rough = truth;
    ASSERT_TRUE(setOnSensor("quantisation=2", rough.sensor));
    EXPECT_GT(shareOf(waterfallTo(rough, truth), "encoding"), 0.999);
}

TEST(PictureWaterfall, SharesAddUpWithEverythingAtOnce)
{
    const Scene truth = plainScene();
    Scene scene = twoLightScene("phong", 8);
    ASSERT_TRUE(setOnSensor("noise=20:full_well=2000", scene.sensor));
    ASSERT_TRUE(setOnSensor("vignetting=cos4", scene.sensor));
    const Waterfall waterfall = waterfallTo(scene, truth, Precision::Float);
    double sum = 0.0;
    for (const WaterfallStep& step : waterfall.steps) {
        EXPECT_NE(step.rmse, 0.0) << step.step;
        sum += step.share;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12); // 4608 sums of products
}

TEST(PictureWaterfall, FalseColoursAreNoLoss)
{
    const Scene truth = plainScene();
    Scene painted = truth;
    painted.sensor.view = {SensorViewKind::FalseColor, true};
    EXPECT_EQ(waterfallTo(painted, truth).rmse, waterfallTo(truth, truth).rmse);
}

} // namespace
} // namespace reflectance::test
