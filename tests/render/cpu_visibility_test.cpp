// What the CPU renderer sees: a tessellated sphere against the sphere's own formula.
#include "core/render/cpu/cpu_renderer.h"
#include "tests/render/sphere.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance::test {
namespace {

constexpr RenderSettings small{96, 80, 2};

ViewSamples view(const Scene& scene, const RenderSettings& settings)
{
    return sampleView(*makeRayScene(scene.mesh), scene.camera, settings);
}

Vec3d position(const ViewSamples& s, std::size_t i)
{
    return {s.Px[i], s.Py[i], s.Pz[i]};
}

Vec3d normal(const ViewSamples& s, std::size_t i)
{
    return {s.Nx[i], s.Ny[i], s.Nz[i]};
}

TEST(CpuVisibility, NormalsAreThoseOfTheSphere)
{
    const Scene scene = sphereScene("lambert", 256);
    const ViewSamples samples = view(scene, small);
    ASSERT_GT(samples.count(), 5000U);
    // Inside a triangle of edge h on the unit sphere the interpolated normal is off by at most about h^3 / 18 sqrt(3)
    // and the surface by h^2 / 8; the diagonal of a quad here is pi/256 sqrt(2).
    const double h = std::numbers::pi / 256.0 * std::numbers::sqrt2;
    for (std::size_t i = 0; i < samples.count(); ++i) {
        const Vec3d P = position(samples, i);
        ASSERT_NEAR(length(P), 1.0, h * h / 8.0 * 1.01);
        ASSERT_NEAR(length(normal(samples, i)), 1.0, 4e-16);
        ASSERT_LE(length(normal(samples, i) - normalized(P)), h * h * h / 8.0);
    }
}

/// Of many triangles and few samples Embree's tree is made in another way.
TEST(CpuVisibility, ATreeMadeForFewRaysMeetsTheSame)
{
    const Scene scene = sphereScene("lambert", 256);
    ASSERT_GT(16 * scene.mesh->triangles.size(), small.samples());
    const ViewSamples once = sampleView(*makeRayScene(scene.mesh, small), scene.camera, small);
    const ViewSamples often = view(scene, small);
    EXPECT_EQ(once.firstOfPixel, often.firstOfPixel);
    EXPECT_EQ(once.triangle, often.triangle);
    EXPECT_EQ(once.Px, often.Px);
    EXPECT_EQ(once.Nz, often.Nz);
    Scene other = scene;
    other.camera.eye.x += 0.01;
    EXPECT_NE(once.triangle, view(other, small).triangle) << "the planted fault";
}

TEST(CpuVisibility, SamplesLieOnTheirRays)
{
    const Scene scene = sphereScene("lambert");
    const ViewSamples samples = view(scene, small);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const std::size_t pixel = Image::pixelCount(small.width, y) + static_cast<std::size_t>(x);
            const std::uint32_t first = samples.firstOfPixel[pixel];
            if (samples.firstOfPixel[pixel + 1] - first != 4)
                continue;
            for (std::uint32_t s = 0; s < 4; ++s) {
                const std::uint32_t row = s / 2, column = s % 2;
                const Vec3d ray = rayThrough(scene.camera, x + (column + 0.5) / 2.0, y + (row + 0.5) / 2.0, small.width,
                                             small.height);
                const Vec3d off = cross(position(samples, first + s) - scene.camera.eye, ray);
                // Where the float ray chose the neighbour, the point is moved by float rounding; elsewhere by 1e-15.
                ASSERT_LE(length(off), 1e-6);
            }
        }
}

TEST(CpuVisibility, CoverageIsTheAreaOfTheDisc)
{
    const RenderSettings settings{200, 200, 4};
    const Scene scene = sphereScene("lambert", 256);
    const ViewSamples samples = view(scene, settings);
    // The sphere's outline is the cone of half-angle asin(1/4): a disc in the image plane.
    const double perUnit = 100.0 * 4.0 / std::tan(scene.camera.fieldOfView * std::numbers::pi / 360.0);
    const double radius = perUnit * std::tan(std::asin(0.25));
    const double area = std::numbers::pi * radius * radius;
    // A lattice count of a disc is off by less than its perimeter times a fraction of a cell; the mesh loses h^2 / 8.
    EXPECT_NEAR(static_cast<double>(samples.count()), area, 0.1 * 2.0 * std::numbers::pi * radius + area * 2e-4);
    EXPECT_EQ(samples.firstOfPixel.size(), 200U * 200U + 1U);
    EXPECT_EQ(samples.firstOfPixel.back(), samples.count());
}

TEST(CpuVisibility, DistanceDoesNotCoarsenIt)
{
    Scene scene = sphereScene("lambert", 256);
    scene.camera.eye = {0.0, 0.0, 1000.0};
    scene.camera.fieldOfView = 1.0;
    const RenderSettings settings{400, 400, 1};
    const ViewSamples samples = view(scene, settings);
    const double radius = 200.0 * std::tan(std::asin(1e-3)) / std::tan(0.5 * std::numbers::pi / 180.0);
    const double area = std::numbers::pi * radius * radius;
    EXPECT_NEAR(static_cast<double>(samples.count()), area, 0.1 * 2.0 * std::numbers::pi * radius + area * 2e-4);
}

TEST(CpuVisibility, SeesTheInsideOfAnOpenMeshWithNormalsTowardsTheViewer)
{
    Scene scene = sphereScene("lambert");
    scene.camera.eye = {0.0, 0.0, 0.2};
    const ViewSamples samples = view(scene, small);
    EXPECT_EQ(samples.count(), 96U * 80U * 4U);
    for (std::size_t i = 0; i < samples.count(); ++i)
        ASSERT_LT(dot(normal(samples, i), position(samples, i)), 0.0);
}

TEST(CpuVisibility, OppositeVertexNormalsGiveWayToTheTriangle)
{
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    mesh->normals = {{0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
    mesh->triangles = {{0, 1, 2}};
    Scene scene = sphereScene("lambert");
    scene.mesh = mesh;
    const ViewSamples samples = view(scene, small);
    ASSERT_GT(samples.count(), 1000U);
    for (std::size_t i = 0; i < samples.count(); ++i)
        ASSERT_NEAR(std::fabs(samples.Nz[i]), 1.0, 1e-15);
}

TEST(CpuVisibility, AMeshWithoutTrianglesIsNotSeen)
{
    Scene scene = sphereScene("lambert");
    scene.mesh = std::make_shared<Mesh>();
    EXPECT_EQ(view(scene, small).count(), 0U);
}

} // namespace
} // namespace reflectance::test
