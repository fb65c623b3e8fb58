// The map of models that suffice: every pixel's model is within the tolerance there, and nothing cheaper is.
#include "core/render/cpu/cpu_renderer.h"
#include "core/study/trade/sufficient.h"
#include "tests/study/trade/scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

double largestChannel(const Image& a, const Image& b, std::size_t pixel)
{
    double largest = 0.0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
        largest = std::max(largest, std::fabs(static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i])));
    return largest;
}

TEST(SufficientModels, HoldAtEveryPixelAndNothingCheaperDoes)
{
    const Scene scene = shinyScene();
    constexpr double tolerance = 0.02;
    const auto map = sufficientModels(scene, smallSettings, tolerance, Metric::Max);
    ASSERT_TRUE(map);
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, smallSettings);
    std::vector<Image> pictures;
    for (const SufficientModel& model : map->models)
        pictures.push_back(shadeSamples(samples, model.recipe.scene, Precision::Double));
    const Image& whole = pictures.back();
    std::size_t covered = 0;
    for (std::size_t pixel = 0; pixel < whole.pixels(); ++pixel) {
        if (!(whole.coverage[pixel] > 0.0F)) {
            EXPECT_EQ(map->modelOf[pixel], SufficientMap::background);
            continue;
        }
        ++covered;
        const std::size_t chosen = map->modelOf[pixel];
        EXPECT_LE(largestChannel(pictures[chosen], whole, pixel), tolerance);
        for (std::size_t cheaper = 0; cheaper < chosen; ++cheaper)
            EXPECT_GT(largestChannel(pictures[cheaper], whole, pixel), tolerance);
    }
    std::size_t counted = 0;
    for (const SufficientModel& model : map->models)
        counted += model.pixels;
    EXPECT_EQ(counted, covered);
    EXPECT_EQ(painted(*map).size(), 3 * whole.pixels());
}

TEST(SufficientModels, LeaveTheHighlightToTheWholeSurface)
{
    const auto map = sufficientModels(shinyScene(), smallSettings, 0.05, Metric::Max);
    ASSERT_TRUE(map);
    std::size_t with = 0, without = 0; // with K as it is or a simpler one: which costs less is for the machine to say
    for (const SufficientModel& m : map->models) {
        const auto& rungs = m.recipe.rungs;
        (std::find(rungs.begin(), rungs.end(), "no_highlight") == rungs.end() ? with : without) += m.pixels;
    }
    EXPECT_GT(without, 0U) << "beside the highlight a matte body is enough";
    EXPECT_GT(with, 0U) << "in it only a surface with a highlight is";
}

TEST(SufficientModels, ATighterToleranceNeedsNoFewerOfTheWhole)
{
    std::size_t before = 0;
    for (const double tolerance : {1.0, 0.1, 0.01, 0.0}) {
        const auto map = sufficientModels(shinyScene(), smallSettings, tolerance, Metric::DeltaE);
        EXPECT_GE(map->models.back().pixels, before);
        before = map->models.back().pixels;
    }
}

TEST(SufficientModels, StopWhenAsked)
{
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(sufficientModels(shinyScene(), smallSettings, 0.1, Metric::Max, &progress));
}

} // namespace
} // namespace reflectance::test
