// Shading per vertex: exact where the model is linear over a triangle, and losing highlights where it is not.
#include "core/render/cpu/shading_places.h"
#include "tests/render/sphere.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace reflectance::test {
namespace {

constexpr RenderSettings small{64, 64, 2};

/// One triangle in the plane z = 0 that faces the viewer, its normals turned outward at the corners.
Scene triangleScene(double bend)
{
    Mesh mesh;
    mesh.positions = {{-0.8, -0.6, 0.0}, {0.8, -0.6, 0.0}, {0.0, 0.8, 0.0}};
    for (const Vec3d& P : mesh.positions)
        mesh.normals.push_back(normalized(Vec3d(bend * P.x, bend * P.y, 1.0)));
    mesh.fileVertex = {0, 1, 2};
    mesh.fileVertexCount = 3;
    mesh.triangles = {{0, 1, 2}};
    Scene scene = sphereScene("lambert", 4);
    scene.mesh = std::make_shared<const Mesh>(std::move(mesh));
    scene.camera.eye = {0.0, 0.0, 4.0};
    scene.lights.resize(1);
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].direction = {0.2, 0.3, 1.0};
    scene.surface.model = "lambert";
    return scene;
}

Image shadedAt(Place place, const ViewSamples& samples, const Scene& scene)
{
    return shadePlaces(placedView(std::make_shared<const ViewSamples>(samples), *scene.mesh, place), scene,
                       Precision::Double);
}

double largestDifference(const Image& a, const Image& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        largest = std::max(largest, std::fabs(static_cast<double>(a.rgb[i]) - b.rgb[i]));
    return largest;
}

double brightest(const Image& image)
{
    return *std::max_element(image.rgb.begin(), image.rgb.end());
}

TEST(VertexShading, IsShadingPerSampleOnAFlatTriangle)
{
    const Scene scene = triangleScene(0.0);
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, small);
    // One N, one L: the same value everywhere, up to the floats in which vertex colours and picture are kept.
    EXPECT_LE(
        largestDifference(shadedAt(Place::Vertex, samples, scene), shadeSamples(samples, scene, Precision::Double)),
        2e-7);
}

TEST(VertexShading, InterpolatesTheCornersLinearly)
{
    const Scene scene = triangleScene(0.5);
    ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, {1, 1, 1});
    ASSERT_EQ(samples.count(), 1U);
    const Vec3d centroid = (scene.mesh->positions[0] + scene.mesh->positions[1] + scene.mesh->positions[2]) / 3.0;
    samples.Px[0] = centroid.x;
    samples.Py[0] = centroid.y;
    samples.Pz[0] = centroid.z;
    double mean = 0.0;
    for (const Vec3d& N : scene.mesh->normals)
        mean += valuesOf(scene)[0] * std::max(0.0, dot(N, normalized(scene.lights[0].direction))) / 3.0;
    // 2e-7: vertex colours are kept as floats.
    EXPECT_NEAR(shadedAt(Place::Vertex, samples, scene).rgb[0], mean * scene.lights[0].intensity.x, 2e-7);
}

TEST(VertexShading, LosesAHighlightInsideATriangle) // what the choice is there to show
{
    Scene scene = triangleScene(0.5);
    scene.surface.model = "phong";
    scene.surface.values["n"] = {200.0};
    scene.lights[0].direction = {0.0, 0.0, 1.0};
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, small);
    EXPECT_GT(brightest(shadeSamples(samples, scene, Precision::Double)), 0.4); // ks = 0.5 at the peak
    scene.background.color = {};
    EXPECT_LT(brightest(shadedAt(Place::Vertex, samples, scene)), 0.01);
}

TEST(VertexShading, GivesTheInsideItsOwnColours)
{
    Scene scene = triangleScene(0.0);
    scene.camera.eye = {0.0, 0.0, -4.0};
    scene.lights[0].direction = {0.0, 0.0, -1.0};
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, small);
    EXPECT_LE(
        largestDifference(shadedAt(Place::Vertex, samples, scene), shadeSamples(samples, scene, Precision::Double)),
        2e-7);
    EXPECT_GT(brightest(shadedAt(Place::Vertex, samples, scene)), 0.5); // kd = 0.8, lit from behind
}

TEST(PixelShading, IsShadingPerSampleWhereLightIsFlat)
{
    const Scene scene = triangleScene(0.0);
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, small);
    for (const Place place : {Place::Pixel, Place::Fragment, Place::Face})
        EXPECT_LE(largestDifference(shadedAt(place, samples, scene), shadedAt(Place::Sample, samples, scene)), 2e-7)
            << nameOf(place) << ": silhouettes included, up to the floats in which colours are kept";
}

TEST(PixelShading, EvaluatesOncePerCoveredPixel)
{
    const Scene scene = sphereScene("lambert", 16);
    const auto samples =
        std::make_shared<const ViewSamples>(sampleView(*makeRayScene(scene.mesh), scene.camera, small));
    const PlacedView view = placedView(samples, *scene.mesh, Place::Pixel);
    std::size_t covered = 0;
    for (std::size_t i = 0; i + 1 < samples->firstOfPixel.size(); ++i)
        covered += samples->firstOfPixel[i + 1] > samples->firstOfPixel[i] ? 1 : 0;
    EXPECT_EQ(view.shadings(), covered);
    EXPECT_LT(3 * view.shadings(), samples->count());
}

/// Where one pixel sees two triangles, each has a shading of its own: an edge between colours stays an edge.
TEST(FragmentShading, EvaluatesOncePerTriangleOfAPixel)
{
    const Scene scene = sphereScene("lambert", 16);
    const auto samples =
        std::make_shared<const ViewSamples>(sampleView(*makeRayScene(scene.mesh), scene.camera, small));
    const PlacedView view = placedView(samples, *scene.mesh, Place::Fragment);
    std::set<std::pair<std::size_t, std::uint32_t>> fragments;
    for (std::size_t pixel = 0; pixel + 1 < samples->firstOfPixel.size(); ++pixel)
        for (std::size_t i = samples->firstOfPixel[pixel]; i < samples->firstOfPixel[pixel + 1]; ++i) {
            fragments.emplace(pixel, samples->triangle[i]);
            EXPECT_EQ(view.places.triangle[view.placesOf[i]], samples->triangle[i]);
        }
    EXPECT_EQ(view.shadings(), fragments.size());
    EXPECT_GT(view.shadings(), placedView(samples, *scene.mesh, Place::Pixel).shadings());
}

TEST(FaceShading, TakesTheFacesOwnNormal)
{
    Scene scene = triangleScene(0.5); // vertex normals bent outward, the face looks straight ahead
    scene.lights[0].direction = {0.0, 0.0, 1.0};
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, small);
    EXPECT_NEAR(brightest(shadedAt(Place::Face, samples, scene)), valuesOf(scene)[0], 1e-7);
    EXPECT_LT(brightest(shadedAt(Place::Vertex, samples, scene)), 0.95 * valuesOf(scene)[0]) << "the planted fault";
}

} // namespace
} // namespace reflectance::test
