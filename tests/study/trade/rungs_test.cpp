// Rungs: what each promises is held to on scenes of every kind, and what does not apply says why.
#include "core/image/compare.h"
#include "core/study/trade/bounds.h"
#include "core/study/trade/rung.h"
#include "core/study/trade/workshop.h"
#include "tests/study/trade/scenes.h"

#include <gmock/gmock.h>
#include <set>

namespace reflectance::test {
namespace {

using testing::HasSubstr;

Image drawn(const Recipe& recipe)
{
    Workshop workshop(recipe.scene.mesh, recipe.scene.camera, nullptr);
    const auto prepared = workshop.prepare(recipe);
    return *workshop.picture(*prepared);
}

double largestChange(const Recipe& before, const Recipe& after)
{
    return compared(drawn(before), drawn(after))->maxAbs;
}

/// Pictures are stored as floats: two roundings of values below 2.
constexpr double stored = 2.5e-7;

TEST(Rungs, HaveNamesOfTheirOwn)
{
    std::set<std::string> ids;
    for (const Rung& rung : rungs()) {
        EXPECT_TRUE(ids.insert(rung.id).second) << rung.id;
        EXPECT_EQ(findRung(rung.id), &rung);
        EXPECT_TRUE(rung.onCpu || rung.onGl) << rung.id;
        EXPECT_NE(std::string(rung.about), "") << rung.id;
    }
    EXPECT_EQ(findRung("k_diagonl"), nullptr);
}

TEST(Rungs, KeepWhatTheyPromise)
{
    int promised = 0;
    double tightest = 0.0; // largest share of a promise that was used up
    for (const Scene& scene : manyScenes())
        for (const Rung& rung : rungs()) {
            if (!rung.onCpu)
                continue;
            const Recipe before{scene, smallSettings};
            Recipe after = before;
            const Applied applied = applyRung(rung, after);
            if (!applied.skipped.empty() || !applied.bound)
                continue;
            ++promised;
            const double change = largestChange(before, after);
            EXPECT_LE(change, *applied.bound + stored) << rung.id << " on " << scene.surface.model;
            tightest = std::max(tightest, change / *applied.bound);
        }
    EXPECT_GE(promised, 12);
    // The planted fault: promises are not so wide that anything would keep them.
    EXPECT_GT(tightest, 0.5);
}

TEST(Rungs, ThatDoNotApplyLeaveTheRecipeAndSayWhy)
{
    int skipped = 0;
    for (const Scene& scene : manyScenes())
        for (const Rung& rung : rungs()) {
            Recipe recipe{scene, smallSettings};
            const Applied applied = applyRung(rung, recipe);
            if (applied.skipped.empty()) {
                EXPECT_EQ(recipe.rungs, std::vector<std::string>{rung.id});
                continue;
            }
            ++skipped;
            EXPECT_TRUE(recipe.rungs.empty()) << rung.id;
            EXPECT_EQ(recipe.scene.surface, scene.surface) << rung.id;
            EXPECT_EQ(recipe.scene.lights, scene.lights) << rung.id;
            EXPECT_FALSE(applied.bound) << rung.id;
        }
    EXPECT_GT(skipped, 50);
}

TEST(Rungs, EveryOneAppliesSomewhere)
{
    std::vector<Scene> scenes = manyScenes();
    Scene inPicture = shinyScene();
    inPicture.surface.model = "mirror";
    inPicture.environment.kind = EnvironmentKind::Map;
    inPicture.environment.map = std::make_shared<const Image>(16, 8);
    scenes.push_back(inPicture);
    scenes.push_back(shinyScene());
    scenes.back().surface.values["n"] = {30.0};                            // squarings are made for whole exponents
    scenes.back().surface.values["K"] = {0.5, 0, 0, 0, 0.4, 0, 0, 0, 0.3}; // and there is something to leave out
    for (const Rung& rung : rungs()) {
        bool applies = false;
        for (const Scene& scene : scenes)
            for (const Precision precision : {Precision::Double, Precision::Glsl})
                for (const int samplesPerAxis : {1, 2}) {
                    Recipe recipe{scene, {40, 40, samplesPerAxis}};
                    recipe.precision = precision;
                    applies = applies || applyRung(rung, recipe).skipped.empty();
                }
        EXPECT_TRUE(applies) << rung.id;
    }
}

TEST(Rungs, TheColourUnderWhiteIsRightUnderWhite)
{
    Scene scene = shinyScene();
    for (Light& light : scene.lights)
        light.intensity = Vec3d(0.5);
    const Recipe before{scene, smallSettings};
    Recipe white = before, diagonal = before;
    ASSERT_TRUE(applyRung(*findRung("k_white"), white).skipped.empty());
    ASSERT_TRUE(applyRung(*findRung("k_diagonal"), diagonal).skipped.empty());
    EXPECT_LE(largestChange(before, white), stored);
    EXPECT_GT(largestChange(before, diagonal), 0.02) << "the planted fault: without the off-diagonals white is darker";
}

TEST(Rungs, OneLightColourIsTheSamePictureInEveryArithmeticButForRoundings)
{
    Scene scene = shinyScene();
    for (Light& light : scene.lights)
        light.intensity = light.intensity.x * Vec3d(1.0, 0.75, 0.5);
    const Rung& rung = *findRung("one_light_colour");
    for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd}) {
        Recipe before{scene, smallSettings};
        before.precision = precision;
        Recipe after = before;
        const Applied applied = applyRung(rung, after);
        ASSERT_TRUE(applied.bound) << applied.skipped;
        EXPECT_LE(largestChange(before, after), *applied.bound + stored) << nameOf(precision);
    }
    // The planted fault: lights of two colours taken for one would be seen.
    Recipe coloured{scene, smallSettings};
    coloured.scene.lights[0].intensity = {0.9, 0.7, 0.4};
    EXPECT_THAT(applyRung(rung, coloured).skipped, HasSubstr("different colours"));
    EXPECT_GT(largestChange(Recipe{scene, smallSettings}, coloured), 1e-3);
    coloured.scene.lights.clear();
    EXPECT_THAT(applyRung(rung, coloured).skipped, HasSubstr("no light"));
}

TEST(Rungs, RoughSurfacesKeepTheirBrightnessSeenFromTheLight)
{
    Scene scene = shinyScene();
    scene.surface.model = "oren_nayar_full";
    scene.lights.resize(1);
    scene.lights[0].direction = scene.camera.eye;
    for (const char* id : {"oren_nayar", "eon", "eon_polynomial", "lambert"}) {
        const Recipe before{scene, {41, 41, 1}};
        Recipe after = before;
        ASSERT_TRUE(applyRung(*findRung(id), after).skipped.empty()) << id;
        const Image a = drawn(before), b = drawn(after);
        for (int channel = 0; channel < 3; ++channel)
            // In the middle N, L and V agree up to 1/40 of the sphere, a few degrees.
            EXPECT_NEAR(b.at(20, 20)[channel] / a.at(20, 20)[channel], 1.0, 0.02) << id;
    }
}

TEST(Bounds, GrowWithoutEndOnlyWhereALightTouchesTheObject)
{
    Light lamp;
    lamp.kind = LightKind::Point;
    lamp.position = {0.0, 0.0, 3.0};
    lamp.intensity = Vec3d(2.0);
    EXPECT_EQ(*mostArriving(lamp), Vec3d(0.5)); // 2 / (3 - 1)^2
    lamp.position = {0.0, 0.0, 0.9};
    EXPECT_FALSE(mostArriving(lamp));
    Scene scene = shinyScene();
    scene.lights = {lamp};
    Recipe recipe{scene, smallSettings};
    EXPECT_THAT(applyRung(*findRung("lights_fiftieth"), recipe).skipped, HasSubstr("every light"));
}

TEST(Bounds, AreUnknownForModelsNobodyBounded)
{
    Scene scene = shinyScene();
    scene.surface.model = "ggx"; // unbounded as alpha falls
    EXPECT_FALSE(largestRadiance(scene));
    Recipe recipe{scene, smallSettings};
    EXPECT_THAT(applyRung(*findRung("lights_fiftieth"), recipe).skipped, HasSubstr("no bound is known"));
}

} // namespace
} // namespace reflectance::test
