// Surfaces that a scene keeps under names: they have names of their own, and scene files hold them.
#include "core/scene/variants.h"

#include "core/scene/same_scene.h"
#include "core/scene/scene_file.h"

#include <gmock/gmock.h>

namespace reflectance {
namespace {

using testing::HasSubstr;

Scene withVariants()
{
    Scene scene = defaultScene();
    for (const char* model : {"hybrid", "oren_nayar", "oren_nayar"}) {
        scene.surface.model = model;
        scene.surface.values["sigma"] = {0.1 * static_cast<double>(scene.variants.size() + 1)};
        keepVariant(scene, scene.surface);
    }
    return scene;
}

TEST(Variants, HaveNamesOfTheirOwn)
{
    Scene scene = withVariants();
    ASSERT_EQ(scene.variants.size(), 3U);
    EXPECT_EQ(scene.variants[2].name, scene.variants[1].name + " 2");
    EXPECT_TRUE(renameVariant(scene, 2, "rough clay"));
    EXPECT_TRUE(renameVariant(scene, 2, "rough clay")) << "its own name";
    const auto taken = renameVariant(scene, 0, "rough clay");
    ASSERT_FALSE(taken);
    EXPECT_THAT(taken.error().sentence(), HasSubstr("choose another name"));
    EXPECT_FALSE(renameVariant(scene, 0, "  "));
    EXPECT_EQ(scene.variants[0].name, withVariants().variants[0].name);
    EXPECT_EQ(*findVariant(scene, "rough clay"), 2U);
    const auto missing = findVariant(scene, "rough cly");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().sentence(), HasSubstr("did you mean 'rough clay'"));
    EXPECT_THAT(findVariant(defaultScene(), "x").error().sentence(), HasSubstr("'variants'"));
}

TEST(Variants, AreInSceneFilesAndReadBackBitForBit)
{
    Scene scene = withVariants();
    scene.variants[1].surface.values["sigma"] = {1.0 / 3.0};
    const auto read = parseScene(sceneText(scene, ""), "a.json", "");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->variants, scene.variants);
    Scene other = scene;
    other.variants[1].surface.values["sigma"] = {0.3}; // planted
    EXPECT_FALSE(other == scene);
    EXPECT_NE(sceneText(other, ""), sceneText(scene, ""));
    EXPECT_THAT(sceneText(defaultScene(), ""), testing::Not(HasSubstr("variants"))) << "none, nothing written";
}

TEST(Variants, KeepHowTheyAreDrawn)
{
    Scene scene = withVariants();
    scene.variants[1].surface.rungs = {"double", "k_diagonal"};
    scene.other = scene.variants[1].surface;
    const auto read = parseScene(sceneText(scene, ""), "a.json", "");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(read->surface.rungs.empty()) << "as in every older file";
    EXPECT_EQ(read->other->rungs, scene.other->rungs);
    EXPECT_EQ(read->variants, scene.variants);
    EXPECT_THAT(sceneText(defaultScene(), ""), testing::Not(HasSubstr("rungs"))) << "none, nothing written";
}

TEST(Variants, OfABadFileAreRefused)
{
    for (const auto& [text, problem] : std::vector<std::pair<const char*, const char*>>{
             {R"({"variants": {}})", "scene.variants is not a list"},
             {R"({"variants": [{"surface": {}}]})", "has no name"},
             {R"({"variants": [{"name": "a"}, {"name": "a"}]})", "two variants are named 'a'"},
             {R"({"variants": [{"name": "a", "surface": {"model": "phog"}}]})", "phong"},
             {R"({"variants": [{"nam": "a"}]})", "did you mean 'name'"},
             {R"({"pins": [{"at": [0, 0, 0]}]})", "a pin has no name"},
             {R"({"pins": [{"name": "a"}, {"name": "a"}]})", "two pins are named 'a'"},
             {R"({"pins": [{"name": "a", "triangle": 100000000}]})",
              "pin 'a' lies on triangle 100000000, and the mesh has"},
             {R"({"pins": [{"name": "a", "at": [0, 0]}]})", "scene.pins[0].at"},
             {R"({"surface": {"rungs": "double"}})", "scene.surface.rungs must be a list of texts"},
             {R"({"surface": {"rungs": ["duoble"]}})", "unknown rung 'duoble'; did you mean 'double'"},
             {R"({"compare": {"rungs": ["float", "double"]}})", "exclude each other: both choose the precision"},
             {R"({"compare": {"rungs": ["per_face", "glsl"]}})", "belong to different renderers"}}) {
        const auto read = parseScene(text, "a.json", "");
        ASSERT_FALSE(read) << text;
        EXPECT_THAT(read.error().sentence(), HasSubstr(problem));
    }
}

} // namespace
} // namespace reflectance
