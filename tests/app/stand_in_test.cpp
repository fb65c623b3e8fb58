// The stand-in of a big mesh: made once, drawn only while the camera moves and pictures are slow; no test asks a clock.
#include "app/explorer/stand_in.h"

#include <cmath>
#include <gtest/gtest.h>
#include <thread>

namespace reflectance::explorer {
namespace {

constexpr double slow = 80.0, fast = 20.0;

/// A wavy square of 2 * side^2 triangles.
std::shared_ptr<const Mesh> waves(std::uint32_t side)
{
    auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t i = 0; i <= side; ++i)
        for (std::uint32_t j = 0; j <= side; ++j) {
            const double x = 1.2 * j / side - 0.6, y = 1.2 * i / side - 0.6;
            mesh->positions.emplace_back(x, y, 0.1 * std::sin(9.0 * x));
            mesh->normals.push_back(normalized(Vec3d(-0.9 * std::cos(9.0 * x), 0.0, 1.0)));
        }
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t j = 0; j < side; ++j) {
            const std::uint32_t a = i * (side + 1) + j;
            mesh->triangles.push_back({a, a + 1, a + side + 2});
            mesh->triangles.push_back({a, a + side + 2, a + side + 1});
        }
    return mesh;
}

/// Asks until the stand-in has been made: it is made on another thread.
void finish(StandIn& standIn, const std::shared_ptr<const Mesh>& mesh)
{
    const std::size_t before = standIn.made();
    while (standIn.made() == before) {
        EXPECT_EQ(standIn.meshFor(mesh, false, slow), mesh);
        std::this_thread::yield();
    }
}

TEST(StandIn, IsDrawnWhileTheCameraMovesAndOnlyThen)
{
    StandIn standIn([] {});
    const auto mesh = waves(330);
    EXPECT_EQ(standIn.meshFor(mesh, true, slow), mesh) << "until there is one, the mesh itself";
    finish(standIn, mesh);
    EXPECT_EQ(standIn.made(), 1U);
    const auto moving = standIn.meshFor(mesh, true, slow);
    ASSERT_NE(moving, mesh);
    EXPECT_TRUE(standIn.facts().shown);
    EXPECT_EQ(standIn.facts().triangles, moving->triangles.size());
    EXPECT_LE(moving->triangles.size(), StandIn::mostOfStandIn);
    EXPECT_GT(standIn.facts().bytes, moving->triangles.size() * sizeof(Mesh::Triangle));
    EXPECT_EQ(standIn.meshFor(mesh, false, slow), mesh) << "at rest every triangle is there";
    EXPECT_FALSE(standIn.facts().shown);
    EXPECT_EQ(standIn.meshFor(mesh, true, fast), mesh) << "a fast machine needs none";
    EXPECT_EQ(standIn.meshFor(mesh, true, slow), moving) << "made once";
    EXPECT_EQ(standIn.made(), 1U);
}

TEST(StandIn, IsNotMadeForSmallMeshesOrFastMachines)
{
    StandIn standIn([] {});
    const auto small = waves(20), big = waves(330);
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(standIn.meshFor(small, true, slow), small);
        EXPECT_EQ(standIn.meshFor(big, true, fast), big);
    }
    EXPECT_EQ(standIn.facts().triangles, 0U);
    EXPECT_EQ(standIn.made(), 0U);
}

TEST(StandIn, GoesWithItsMesh)
{
    StandIn standIn([] {});
    auto first = waves(330);
    finish(standIn, first);
    const auto second = waves(340);
    EXPECT_EQ(standIn.meshFor(second, true, slow), second) << "never the stand-in of another mesh";
    finish(standIn, second);
    EXPECT_EQ(standIn.made(), 2U);
    EXPECT_NE(standIn.meshFor(second, true, slow), second);
}

} // namespace
} // namespace reflectance::explorer
