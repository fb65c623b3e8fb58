// Meshes that are kept: read once, and the scene is the one that the reader makes.
#include "core/study/sweep/kept_meshes.h"

#include "core/base/file.h"
#include "core/scene/scene_file.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

TEST(KeptMeshes, GiveTheSceneOfTheReader)
{
    KeptMeshes meshes;
    for (int round = 0; round < 2; ++round)
        for (const char* text : {R"({"mesh": "sphere"})", R"({"mesh": "sphere", "smooth_normals": true})", "{}",
                                 R"({"mesh": "mug", "surface": {"model": "lambert"}})"}) {
            const auto kept = meshes.scene(text, "");
            const auto read = parseScene(text, "", "");
            ASSERT_TRUE(kept && read) << text;
            EXPECT_EQ(sceneText(*kept, ""), sceneText(*read, "")) << text;
            EXPECT_EQ(kept->mesh->positions.size(), read->mesh->positions.size()) << text;
            EXPECT_EQ(kept->mesh->normals.front().x, read->mesh->normals.front().x) << text;
        }
    EXPECT_EQ(meshes.size(), 4U) << "{} and mug say it in two ways";
}

/// The file is removed between two cells: whoever reads it again notices.
TEST(KeptMeshes, ReadAFileOnce)
{
    const fs::path file = fs::temp_directory_path() / ("kept_mesh_" + std::to_string(::getpid()) + ".obj");
    ASSERT_TRUE(writeAtomically(file.string(), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    const std::string text = R"({"mesh": ")" + file.filename().string() + R"(", "surface": {"model": ")";
    KeptMeshes meshes;
    const auto first = meshes.scene(text + "lambert\"}}", file.parent_path().string());
    ASSERT_TRUE(first) << first.error().sentence();
    fs::remove(file);
    const auto second = meshes.scene(text + "phong\"}}", file.parent_path().string());
    ASSERT_TRUE(second) << second.error().sentence();
    EXPECT_EQ(first->mesh, second->mesh);
    EXPECT_EQ(meshes.rays(*first), meshes.rays(*second)) << "nor is Embree's structure made twice";
    EXPECT_FALSE(KeptMeshes().scene(text + "phong\"}}", file.parent_path().string())) << "the file is gone";
}

} // namespace
} // namespace reflectance
