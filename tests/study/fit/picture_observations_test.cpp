// The surface is found again from a picture of it.
#include "core/study/fit/picture_observations.h"

#include "core/base/text.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/study/fit/fit.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace reflectance;
using testing::HasSubstr;

namespace {

/// The mug with a white diagonal K, so that a fit of the diagonal can find it.
Scene shinyMug()
{
    Scene scene = defaultScene();
    scene.camera = framed(scene.camera, 1.0);
    scene.surface.model = "hybrid";
    scene.surface.values = {{"K", {0.5, 0, 0, 0, 0.3, 0, 0, 0, 0.2}}, {"n", {30.0}}};
    return scene;
}

Picture picture(const Scene& scene, int samplesPerAxis = 1)
{
    return {renderOnCpu(scene, {96, 96, samplesPerAxis}, Precision::Double), PictureFormat::Exr};
}

double fitted(const FitResult& fit, const std::string& name)
{
    for (const FittedNumber& number : fit.numbers)
        if (number.name == name)
            return number.value;
    return NAN;
}

} // namespace

// One sample per pixel is what the fit assumes, so only the picture's rounding to float (6e-8) is left.
TEST(PictureObservations, TheSurfaceIsFoundAgain)
{
    const auto data = observationsOf(picture(shinyMug()), shinyMug());
    ASSERT_TRUE(data) << data.error().sentence();
    EXPECT_GT(data->rows.size(), 500U);
    const auto fit = fitModel(**findModel("hybrid"), *data);
    ASSERT_TRUE(fit) << fit.error().sentence();
    EXPECT_NEAR(fitted(*fit, "K 1 1"), 0.5, 1e-5);
    EXPECT_NEAR(fitted(*fit, "K 3 3"), 0.2, 1e-5);
    EXPECT_NEAR(fitted(*fit, "n"), 30.0, 1e-2);
}

// A pixel of 16 samples is a mean over its area. On a sphere of 96 pixels N turns by 1 to 3 degrees over a pixel, small
// against the highlight's 12 degrees, and edges are left out.
TEST(PictureObservations, ASupersampledPictureServesToo)
{
    Scene sphere = shinyMug();
    sphere.meshFile = "sphere";
    ASSERT_TRUE(readMeshOf(sphere));
    const auto fit = fitModel(**findModel("hybrid"), *observationsOf(picture(sphere, 4), sphere));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fitted(*fit, "K 1 1"), 0.5, 0.01);
    EXPECT_NEAR(fitted(*fit, "n"), 30.0, 1.5);
}

TEST(PictureObservations, TheSceneOfAnotherLightIsNotExplained)
{
    Scene other = shinyMug();
    other.lights.front().direction = {-1.0, 0.2, 0.3};
    const auto fit = fitModel(**findModel("hybrid"), *observationsOf(picture(shinyMug()), other));
    ASSERT_TRUE(fit);
    EXPECT_GT(fit->relativeRms, 0.2);
}

TEST(PictureObservations, AnExposedPngIsTakenBackToRadiance)
{
    Scene scene = shinyMug();
    scene.sensor.exposure = -1.0;
    Picture png = picture(scene);
    png.format = PictureFormat::Png;
    for (float& value : png.image.rgb)
        value *= 0.5F; // what the sensor did; clipped and black pixels drop out
    const auto data = observationsOf(png, scene);
    ASSERT_TRUE(data);
    EXPECT_NEAR(fitted(*fitModel(**findModel("hybrid"), *data), "K 1 1"), 0.5, 1e-4);
}

TEST(PictureObservations, PixelsAreChosenOrRefused)
{
    const Scene scene = shinyMug();
    const Picture mug = picture(scene);
    const std::vector<PixelPlace> middle{{48, 48}, {50, 52}, {40, 44}};
    const auto chosen = observationsOf(mug, scene, middle);
    ASSERT_TRUE(chosen);
    EXPECT_LE(chosen->rows.size(), 3U);
    const std::vector<PixelPlace> outside{{96, 0}};
    EXPECT_THAT(observationsOf(mug, scene, outside).error().message, HasSubstr("96,0 lies outside"));
    const std::vector<PixelPlace> beside{{0, 0}};
    EXPECT_THAT(observationsOf(mug, scene, beside).error().message, HasSubstr("0,0 does not show the object"));
    Scene dark = scene;
    dark.lights.clear();
    EXPECT_THAT(observationsOf(mug, dark).error().message, HasSubstr("no pixel shows the object"));
}
