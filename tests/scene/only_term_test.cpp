// A term alone: what is seen of it, and that the terms of a picture add up to it.
#include "core/scene/only_term.h"

#include "core/reflectance/evaluate.h"
#include "core/scene/requirements.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

using Names = std::vector<std::string>;

Scene sceneWith(const std::string& model)
{
    Scene scene = defaultScene();
    scene.surface.model = model;
    return scene;
}

/// What the surface gives under its first light that is on, seen from a side; black without one.
Vec3d seen(const Scene& scene)
{
    const Vec3d N{0.0, 0.0, 1.0};
    std::vector<ObservedLight> lights;
    for (const Light& light : scene.lights)
        if (light.on)
            lights.push_back({{0.3, 0.1, 0.9}, light.intensity, 10.0});
    const std::vector<Observation> rows{{N, {-0.35, -0.1, 0.9}, lights}};
    return evaluate(modelOf(scene), valuesOf(scene), rows, Precision::Double)[0];
}

Vec3d alone(const Scene& scene, const std::string& term)
{
    const auto one = onlyTerm(scene, term);
    EXPECT_TRUE(one) << term;
    return one ? seen(*one) : Vec3d();
}

TEST(OnlyTerm, NamesWhatThereIs)
{
    EXPECT_EQ(termsAlone(sceneWith("hybrid")), (Names{"diffuse", "specular", "offdiagonal", "light:1", "light:2"}));
    EXPECT_EQ(termsAlone(sceneWith("phong")), (Names{"light:1", "light:2"})) << "one term is the picture";
    EXPECT_EQ(termsAlone(sceneWith("oren_nayar_full")), (Names{"term 1", "term 2", "light:1", "light:2"}));
    Scene grey = sceneWith("lambert_color");
    EXPECT_EQ(termsAlone(grey), (Names{"offdiagonal", "light:1", "light:2"}));
    grey.surface.values["K"] = {0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5};
    EXPECT_EQ(termsAlone(grey), (Names{"light:1", "light:2"})) << "nothing is beside the diagonal";
    grey.other = sceneWith("hybrid").surface;
    EXPECT_EQ(termsAlone(grey), (Names{"diffuse", "specular", "offdiagonal", "light:1", "light:2"})) << "B has them";
}

/// Terms are summed once more than in the formula, whose gates and factors outside are the same: a few roundings.
TEST(OnlyTerm, TheTermsOfEveryModelAddUp)
{
    int sums = 0;
    for (const Model& model : catalogue()) {
        if (model.text.usesTable)
            continue;
        const Scene scene = sceneWith(model.id());
        Vec3d sum;
        double largest = 0.0;
        int terms = 0;
        for (const std::string& term : termsAlone(scene))
            if (!term.starts_with("light:") && term != "offdiagonal") {
                const Vec3d value = alone(scene, term);
                sum += value;
                largest = std::max(largest, length(value));
                ++terms;
            }
        if (terms == 0)
            continue;
        ++sums;
        EXPECT_GT(terms, 1) << model.id();
        EXPECT_LE(length(sum - seen(scene)), 16.0 * 2.2e-16 * largest) << model.id();
    }
    EXPECT_GT(sums, 4);
}

TEST(OnlyTerm, LightsAddUp)
{
    const Scene scene = sceneWith("hybrid");
    const Vec3d sum = alone(scene, "light:1") + alone(scene, "light:2");
    EXPECT_LE(length(sum - seen(scene)), 4.0 * 2.2e-16 * length(sum)); // one sum in another order
}

TEST(OnlyTerm, DiffuseIsTheMatrixAloneAndOffDiagonalWhatADiagonalLeavesOut)
{
    const Scene scene = sceneWith("hybrid");
    EXPECT_LE(length(alone(scene, "diffuse") - seen(sceneWith("lambert_color"))), 1e-15); // cosine from the other side
    Scene diagonal = sceneWith("lambert_color");
    std::vector<double> K = valueOf(*modelOf(diagonal).text.find("K"), {});
    for (const std::size_t off : {1U, 2U, 3U, 5U, 6U, 7U})
        K[off] = 0.0;
    diagonal.surface.values["K"] = K;
    EXPECT_LE(length(alone(scene, "offdiagonal") + seen(diagonal) - seen(sceneWith("lambert_color"))), 1e-15);
    EXPECT_GT(length(alone(scene, "offdiagonal")), 0.01) << "planted: an empty view would pass the sums above";
}

TEST(OnlyTerm, ASurfaceWithoutTheTermIsBlack)
{
    Scene scene = sceneWith("hybrid");
    scene.other = sceneWith("phong").surface;
    const auto diffuse = onlyTerm(scene, "diffuse");
    ASSERT_TRUE(diffuse);
    EXPECT_EQ(seen(variantB(*diffuse)), Vec3d()) << "Phong's has nothing diffuse";
    const auto specular = onlyTerm(scene, "specular");
    ASSERT_TRUE(specular);
    EXPECT_EQ(seen(variantB(*specular)), seen(variantB(scene))) << "and is specular as a whole";
}

/// Else a renderer would take every frame for another picture.
TEST(OnlyTerm, AskedTwiceGivesTheSameModel)
{
    const Scene scene = sceneWith("hybrid");
    const auto a = onlyTerm(scene, "specular"), b = onlyTerm(scene, "specular");
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->surface, b->surface);
    EXPECT_FALSE(a->surface == onlyTerm(scene, "diffuse")->surface);
    EXPECT_FALSE(requirementsOf(*a) == requirementsOf(scene)) << "it is another shader";
}

/// The limits that the whole declares (ks = 0 is Lambert) are not those of its parts.
TEST(OnlyTerm, APartIsNotTakenForTheLimitOfTheWhole)
{
    Scene scene = sceneWith("hybrid");
    scene.surface.values["ks"] = {0.0};
    const auto specular = onlyTerm(scene, "specular");
    ASSERT_TRUE(specular);
    EXPECT_EQ(seen(*specular), Vec3d());
    EXPECT_EQ(requirementsOf(*specular).own, specular->surface.own);
}

TEST(OnlyTerm, RefusesWhatThereIsNot)
{
    for (const char* term : {"gloss", "", "light:3", "light:0", "light:", "light:x"}) {
        const auto none = onlyTerm(sceneWith("hybrid"), term);
        ASSERT_FALSE(none) << term;
        EXPECT_NE(none.error().message.find("diffuse, specular, offdiagonal, light:1, light:2"), std::string::npos);
    }
}

} // namespace
} // namespace reflectance
