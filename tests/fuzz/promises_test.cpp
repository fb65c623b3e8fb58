// The judges must be able to say no: for each promise one planted value that breaks it.
#include "tests/fuzz/promises.h"

#include "core/scene/scene_file.h"

#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace reflectance::fuzz {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string judged(const std::function<void(Mesh&)>& spoil, std::size_t bytes = triangle.size())
{
    LoadedMesh loaded = *readMesh(triangle, "a.obj");
    Mesh mesh = *loaded.mesh;
    spoil(mesh);
    loaded.mesh = std::make_shared<Mesh>(std::move(mesh));
    return brokenPromise(loaded, bytes);
}

TEST(Promises, AGoodMeshKeepsThem)
{
    EXPECT_EQ(judged([](Mesh&) {}), "");
}

TEST(Promises, EveryWrongMeshIsNoticed)
{
    EXPECT_NE(judged([](Mesh& m) { m.positions[1].y = nan; }), "");
    EXPECT_NE(judged([](Mesh& m) { m.positions[1] = {2, 0, 0}; }), "");
    EXPECT_NE(judged([](Mesh& m) { m.normals[0] = {0, 0, 1.0001}; }), "");
    EXPECT_NE(judged([](Mesh& m) { m.normals[0] = {nan, 0, 1}; }), "");
    EXPECT_NE(judged([](Mesh& m) { m.normals.pop_back(); }), "");
    EXPECT_NE(judged([](Mesh& m) { m.triangles[0][2] = 3; }), "");
    EXPECT_NE(judged([](Mesh& m) { m.fileVertex[0] = 7; }), "");
    EXPECT_NE(judged([](Mesh& m) { m.triangles.clear(); }), "");
    EXPECT_NE(judged([](Mesh& m) { m.placement.scale = 0.0; }), "");
    EXPECT_NE(judged([](Mesh&) {}, 0), "") << "a mesh out of nothing";
}

TEST(Promises, ARefusalIsOneSentence)
{
    EXPECT_EQ(brokenPromise(Error{"has no usable faces", "a.obj", 3}), "");
    EXPECT_NE(brokenPromise(Error{"", "a.obj"}), "");
    EXPECT_EQ(brokenPromise(Error{"has no faces " + std::string(5000, '!'), "a.obj"}), "") << "cut by sentence()";
    EXPECT_NE(brokenPromise(Error{"has no usable faces", std::string(5000, 'a')}), "");
}

TEST(Promises, WrongPicturesAreNoticed)
{
    Image image(2, 2);
    EXPECT_EQ(brokenPromise(image, 16), "");
    EXPECT_NE(brokenPromise(image, 0), "");
    image.rgb.pop_back();
    EXPECT_NE(brokenPromise(image, 16), "");
}

TEST(Promises, WrongScenesAreNoticed)
{
    const Scene good = defaultScene();
    EXPECT_EQ(brokenPromise(good), "");
    Scene dark = good;
    dark.lights[0].intensity.x = -1.0;
    EXPECT_NE(brokenPromise(dark), "");
    Scene lost = good;
    lost.camera.eye.z = nan;
    EXPECT_NE(brokenPromise(lost), "");
    Scene bare = good;
    bare.mesh.reset();
    EXPECT_NE(brokenPromise(bare), "");
}

TEST(Promises, WrongRowsAndModelsAreNoticed)
{
    auto rows = *cli::parseEvalRows("id,model,N,L,V,light_rgb\na,lambert,0 0 1,0 0 1,0 0 1,1 1 1\n", "a.csv");
    ASSERT_EQ(rows.rows.size(), 1U);
    EXPECT_EQ(brokenPromise(rows), "");
    rows.rows[0].observation.N.x = nan;
    EXPECT_NE(brokenPromise(rows), "");

    ModelText text = catalogue().front().text;
    EXPECT_EQ(brokenPromise(text), "");
    text.parameters.front().initial.clear();
    EXPECT_NE(brokenPromise(text), "");
}

} // namespace
} // namespace reflectance::fuzz
