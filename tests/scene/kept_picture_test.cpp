// The session that a picture carries: it comes back whole, moves with the picture, and what is wrong is one sentence.
#include "core/scene/kept_picture.h"

#include "core/base/version.h"
#include "core/image/formats.h"
#include "core/scene/scene_file.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::uint8_t, 3> onePixel{1, 2, 3};
constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

Scene unusualScene()
{
    Scene scene = defaultScene();
    scene.camera.eye = {0.1, 1.0 / 3.0, -4.0};
    scene.surface.values["n"] = {1e7};
    scene.other = Surface{"oren_nayar", {{"sigma", {0.7}}}};
    scene.sensor.exposure = -3.3;
    return scene;
}

PictureRecipe unusualRecipe()
{
    return {641, 3, 8, "cpu", "simd", "vertex", "power", "half", VariantView::Wipe, 1.0 / 3.0, "specular", true};
}

std::string sessionOf(const Scene& scene, const PictureRecipe& recipe, const std::string& folder = {})
{
    return *findNote(keptNotes(scene, recipe, folder), "reflectance.session");
}

/// An empty folder of this name in the scratch folder.
fs::path emptyFolder(const char* name)
{
    const fs::path folder = fs::path(testing::TempDir()) / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

TEST(KeptPicture, ComesBackWholeFromBothFormats)
{
    const Scene scene = unusualScene();
    const Notes notes = keptNotes(scene, unusualRecipe(), "");
    for (const std::string& bytes : {encodedPng(1, 1, onePixel, {}, notes), encodedExr(Image(1, 1), notes)}) {
        EXPECT_TRUE(carriesSession(bytes));
        const auto kept = keptIn(bytes, "a.picture");
        ASSERT_TRUE(kept) << kept.error().sentence();
        EXPECT_EQ(sceneText(kept->scene, ""), sceneText(scene, ""));
        EXPECT_EQ(kept->recipe, unusualRecipe());
        EXPECT_EQ(kept->program, programVersion());
    }
}

TEST(KeptPicture, ASmallDifferenceIsADifference) // planted
{
    Scene scene = unusualScene();
    const auto kept = parseKept(sessionOf(scene, {}), "a.png", "");
    ASSERT_TRUE(kept);
    scene.sensor.exposure = std::nextafter(scene.sensor.exposure, 0.0);
    EXPECT_NE(sceneText(kept->scene, ""), sceneText(scene, ""));
}

TEST(KeptPicture, FindsAMeshThatMovedTogetherWithIt)
{
    const fs::path before = emptyFolder("before"), after = emptyFolder("after");
    fs::create_directories(before / "meshes");
    std::ofstream(before / "meshes/triangle.obj") << triangle;
    Scene scene = defaultScene();
    scene.meshFile = (before / "meshes/triangle.obj").string();
    ASSERT_TRUE(readMeshOf(scene));
    const std::string session = sessionOf(scene, {}, before.string());
    const auto elsewhere = parseKept(session, "a.png", after.string());
    ASSERT_TRUE(elsewhere) << "where it was: " << elsewhere.error().sentence();
    EXPECT_EQ(elsewhere->scene.meshFile, scene.meshFile);

    fs::rename(before / "meshes", after / "meshes");
    const auto moved = parseKept(session, "a.png", after.string());
    ASSERT_TRUE(moved) << moved.error().sentence();
    EXPECT_EQ(moved->scene.meshFile, (after / "meshes/triangle.obj").string());
    EXPECT_EQ(moved->scene.mesh->triangles.size(), 1U);

    fs::remove_all(after / "meshes");
    const auto gone = parseKept(session, "a.png", after.string());
    ASSERT_FALSE(gone);
    EXPECT_NE(gone.error().sentence().find("triangle.obj"), std::string::npos) << gone.error().sentence();
    EXPECT_EQ(gone.error().sentence().find('\n'), std::string::npos);
}

TEST(KeptPicture, RefusesWhatItCannotMakeAgain)
{
    const std::string good = sessionOf(defaultScene(), {});
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string bad = good;
        const std::size_t at = bad.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        bad.replace(at, from.size(), to);
        const auto kept = parseKept(bad, "a.png", "");
        return kept ? std::string("accepted") : kept.error().sentence();
    };
    const std::string newer = refusal("\"version\": 1", "\"version\": 2");
    EXPECT_NE(newer.find("newer program"), std::string::npos) << newer;
    EXPECT_NE(refusal("\"version\": 2", "\"version\": 99").find("newer program"), std::string::npos)
        << "the scene's own";
    EXPECT_NE(refusal("reflectance.picture", "reflectance.scene").find("another kind of file"), std::string::npos);
    EXPECT_NE(refusal("\"samples\": 4", "\"samples\": 5").find("square"), std::string::npos);
    EXPECT_NE(refusal("\"glsl\"", "\"octuple\"").find("precision"), std::string::npos);
    EXPECT_NE(refusal("\"height\"", "\"hight\"").find("hight"), std::string::npos);
    EXPECT_EQ(refusal("\"width\"", "\"width\""), "accepted");
}

TEST(KeptPicture, SaysThatAnotherPictureCarriesNone)
{
    const auto kept = keptIn(encodedPng(1, 1, onePixel), "photo.png");
    ASSERT_FALSE(kept);
    EXPECT_NE(kept.error().sentence().find("photo.png: this picture carries no session"), std::string::npos);
    EXPECT_FALSE(carriesSession(encodedPng(1, 1, onePixel)));
    EXPECT_FALSE(carriesSession("no picture"));
    EXPECT_FALSE(keptIn("no picture", "a.png"));
    EXPECT_FALSE(loadKept("/nonexistent/a.png"));
}

} // namespace
} // namespace reflectance
