// What the cheats cost on an object, as the page of colour asks for it; the pixel under the mouse; the window's waterfall.
#include "app/explorer/object_price.h"
#include "app/explorer/sensor_study.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/spectra/color_study.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

constexpr RenderSettings settings{40, 30, 1};

ObjectQuestion questionFor(const std::string& model, const std::string& under)
{
    ColorQuestion asked;
    asked.sensor = "narrow"; // few wavelengths: fast
    asked.primaries = "display";
    asked.under = under;
    const auto answer = answered(asked);
    EXPECT_TRUE(answer) << answer.error().sentence();
    Scene scene = defaultScene();
    scene.surface.model = model;
    return {scene, sampleView(*makeRayScene(scene.mesh), scene.camera, settings), answer->system, answer->patches[14],
            answer->light};
}

TEST(ObjectPrice, TheFullKCostsNothingUnderTheScenesLights)
{
    Progress progress;
    const auto found = objectPrices(questionFor("lambert_color", "white"), progress);
    ASSERT_TRUE(found && found->problem.empty());
    ASSERT_EQ(found->prices.size(), std::size(allCheats));
    EXPECT_LT(found->prices[0].max, 1e-3); // pictures are floats
    EXPECT_GT(found->prices[2].max, 0.01) << "the lecture's diagonal";
    EXPECT_EQ(found->light, "the scene's lights");
}

TEST(ObjectPrice, SaysWhyThereIsNone)
{
    Progress progress;
    const auto found = objectPrices(questionFor("lambert", "white"), progress);
    ASSERT_TRUE(found);
    EXPECT_NE(found->problem.find("no matrix K"), std::string::npos);
    progress.cancel = true;
    EXPECT_FALSE(objectPrices(questionFor("lambert_color", "white"), progress));
}

TEST(PixelReading, GivesLinearValuesAndCodesWithinThePicture)
{
    Image image(3, 2);
    image.at(2, 1)[1] = 0.5F;
    const auto reading = readingOf(image, Sensor(), 2, 1);
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->linear, Vec3d(0.0, 0.5, 0.0));
    EXPECT_EQ(quantised(reading->code.y), 188); // sRGB of one half
    EXPECT_FALSE(readingOf(image, Sensor(), 3, 1));
    EXPECT_FALSE(readingOf(image, Sensor(), -1, 0));
}

TEST(WindowWaterfall, TakesBForTheModelsTruth)
{
    Scene scene = defaultScene();
    DrawnByGl drawn{sampleView(*makeRayScene(scene.mesh), scene.camera, settings), {}, 0.0};
    drawn.linear = shadeSamples(drawn.samples, scene, Precision::Float);
    Progress progress;
    const auto alone = windowWaterfall(scene, drawn, progress);
    ASSERT_TRUE(alone);
    EXPECT_EQ(alone->steps.size(), 3U);
    scene.other = scene.surface;
    scene.other->model = "lambert";
    const auto compared = windowWaterfall(scene, drawn, progress);
    ASSERT_TRUE(compared);
    ASSERT_EQ(compared->steps.size(), 4U);
    EXPECT_EQ(compared->steps[0].step, "model");
    EXPECT_GT(compared->steps[0].rmse, compared->steps[1].rmse);
    progress.cancel = true;
    EXPECT_FALSE(windowWaterfall(scene, drawn, progress));
}

} // namespace
} // namespace reflectance::explorer
