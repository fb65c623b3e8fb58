// Rays and surface points are computed in lanes and in packets: to the last bit what is computed one by one.
#include "core/reflectance/kernel_tables.h"
#include "core/render/cpu/lane_work.h"
#include "core/render/cpu/surface_point.h"
#include "core/render/cpu/tile_tracer.h"
#include "tests/render/sphere.h"

#include <cstring>
#include <gtest/gtest.h>
#include <random>

namespace reflectance::test {
namespace {

std::vector<const LaneWork*> worksHere()
{
    std::vector<const LaneWork*> works{&laneWorkSse2()};
    if (std::string_view(lanesName()) == "avx2")
        works.push_back(&laneWorkAvx2());
    return works;
}

bool sameBits(const Vec3d& a, const Vec3d& b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

Camera awry(double fieldOfView)
{
    Camera camera;
    camera.eye = {1.3, -0.7, 2.9};
    camera.fieldOfView = fieldOfView;
    return camera;
}

/// Sixteen rays with room for what `aim` writes.
struct Rays {
    float numbers[6][16] = {};
    int valid[16] = {};

    [[nodiscard]] RayColumns columns()
    {
        return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], valid};
    }
};

TEST(LaneWork, AimsAlongTheRaysOfItsImagePoints)
{
    const double xs[] = {0.5, 516.25, 700.125, 1020.5};
    const double ys[] = {0.5, 100.25, 231.5, 332.75};
    for (const double fieldOfView : {1.0, 35.0, 120.0}) {
        const PixelRays rays(awry(fieldOfView), {1021, 333, 3});
        for (const LaneWork* work : worksHere()) {
            Rays packet;
            ASSERT_TRUE(work->aim(rays.frame(), 10.0, xs, ys, 4, packet.columns())) << "the eye is in the sphere";
            for (std::size_t i = 0; i < 16; ++i) {
                const Vec3f direction(rays.through(xs[i % 4], ys[i / 4]));
                EXPECT_EQ(Vec3f(packet.numbers[3][i], packet.numbers[4][i], packet.numbers[5][i]), direction);
                EXPECT_EQ(Vec3f(packet.numbers[0][i], packet.numbers[1][i], packet.numbers[2][i]),
                          Vec3f(rays.frame().eye));
                EXPECT_EQ(packet.valid[i], -1);
                EXPECT_FALSE(direction == Vec3f(rays.through(xs[i / 4], ys[i / 4] + 1.0)))
                    << "another ray is seen to differ";
            }
        }
    }
}

TEST(LaneWork, StartsRaysAtTheSphereAndLeavesOutThoseThatMissIt)
{
    Camera camera;
    camera.eye = {0.0, 0.0, 1000.0};
    camera.fieldOfView = 1.0;
    const PixelRays rays(camera, {400, 400, 1});
    const double ys[] = {200.0, 100.0, 20.0, 0.5};
    const double xs[] = {200.0, 280.0, 330.0, 399.5}; // a radius of 1 is 23 pixels here
    for (const LaneWork* work : worksHere()) {
        Rays packet;
        EXPECT_TRUE(work->aim(rays.frame(), 1.0, xs, ys, 4, packet.columns()));
        EXPECT_EQ(packet.valid[0], -1);
        EXPECT_NEAR(packet.numbers[2][0], 1.001, 1e-6) << "the float nearest to where the sphere begins";
        for (std::size_t i = 1; i < 16; ++i)
            EXPECT_EQ(packet.valid[i], 0);
        EXPECT_FALSE(work->aim(rays.frame(), 1.0, xs, ys + 1, 2, packet.columns()));
    }
}

/// Triangles of any shape, among them ones without area and ones whose normals cancel.
Mesh wildMesh()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto vector = [&] { return Vec3d(number(random), number(random), number(random)); };
    Mesh mesh;
    for (std::uint32_t i = 0; i < 300; ++i) {
        mesh.positions.push_back(vector());
        mesh.normals.push_back(normalized(vector()));
    }
    for (std::uint32_t i = 0; i + 2 < 300; ++i)
        mesh.triangles.push_back({i, i + 1, i + 2});
    mesh.triangles.push_back({5, 5, 9});
    mesh.triangles.push_back({4, 4, 4});
    mesh.normals[10] = {};
    mesh.normals[11] = {};
    mesh.normals[12] = {};
    mesh.normals[20] = {1e-150, 0.0, 0.0};
    mesh.normals[21] = {0.0, 1e-150, 0.0};
    mesh.normals[22] = {0.0, 0.0, 1e-150};
    return mesh;
}

TEST(LaneWork, FindsSurfacePointsToTheLastBit)
{
    const Mesh mesh = wildMesh();
    const PixelRays rays(awry(35.0), {640, 480, 2});
    std::vector<double> x, y;
    std::vector<std::uint32_t> triangle;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0.0, 480.0);
    for (int i = 0; i < 2000; ++i) {
        x.push_back(place(random));
        y.push_back(place(random));
        triangle.push_back(static_cast<std::uint32_t>(random() % mesh.triangles.size()));
    }
    for (const LaneWork* work : worksHere())
        for (const std::size_t count : {std::size_t{2000}, std::size_t{7}, std::size_t{1}, std::size_t{0}}) {
            std::vector<double> numbers[6];
            std::size_t different = 0;
            for (auto& column : numbers)
                column.assign(count + 1, 42.0);
            work->find(mesh, rays.frame(), {count, x.data(), y.data(), triangle.data()},
                       {numbers[0].data(), numbers[1].data(), numbers[2].data(), numbers[3].data(), numbers[4].data(),
                        numbers[5].data()});
            for (std::size_t i = 0; i < count; ++i) {
                const SurfacePoint point = surfacePoint(mesh, triangle[i], rays.frame().eye, rays.through(x[i], y[i]));
                ASSERT_TRUE(sameBits({numbers[0][i], numbers[1][i], numbers[2][i]}, point.P)) << i;
                ASSERT_TRUE(sameBits({numbers[3][i], numbers[4][i], numbers[5][i]}, point.N)) << i;
                const SurfacePoint beside =
                    surfacePoint(mesh, triangle[i] ^ 1U, rays.frame().eye, rays.through(x[i], y[i]));
                different += sameBits(beside.N, point.N) && sameBits(beside.P, point.P) ? 0U : 1U;
            }
            // Rays beside two triangles may end at the corner that both share.
            EXPECT_GE(10 * different, 9 * count) << "the planted fault: another triangle's points are seen to differ";
            EXPECT_EQ(numbers[0][count], 42.0) << "nothing is written behind the last";
        }
}

TEST(TileTracer, PacketsOfAnySizeMeetTheSameTriangles)
{
    const Scene scene = sphereScene("lambert", 256);
    const RayScene rays(scene.mesh);
    const RenderSettings settings{150, 130, 3};
    const PixelRays pixelRays(scene.camera, settings);
    const Tiles tiles(settings);
    std::size_t met = 0;
    std::size_t different = 0;
    for (int i = 0; i < tiles.count(); ++i) {
        TileHits eight, sixteen;
        traceTile(rays, pixelRays, settings, tiles[i], 8, eight);
        traceTile(rays, pixelRays, settings, tiles[i], 16, sixteen);
        ASSERT_EQ(eight.any, sixteen.any);
        if (!eight.any)
            continue;
        for (int row = 0; row < 3 * tiles[i].height; ++row)
            for (int column = 0; column < 3 * tiles[i].width; ++column) {
                met += eight.at(column, row) != RayScene::nothing ? 1U : 0U;
                different += eight.at(column, row) != sixteen.at(column, row) ? 1U : 0U;
            }
    }
    EXPECT_GT(met, 30'000U);
    // Embree's kernels for either size may round an edge between two triangles differently.
    EXPECT_LE(different, met / 10'000);
}

} // namespace
} // namespace reflectance::test
