// The coarse stand-in of a mesh: few enough triangles, near the surface, turned the right way.
#include "core/geometry/clustered.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

/// A unit sphere of `rings` times twice as many quadrilaterals.
Mesh ball(std::uint32_t rings)
{
    Mesh mesh;
    const std::uint32_t around = 2 * rings;
    for (std::uint32_t i = 0; i <= rings; ++i)
        for (std::uint32_t j = 0; j < around; ++j) {
            const double theta = std::numbers::pi * i / rings, phi = 2.0 * std::numbers::pi * j / around;
            mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                        -std::sin(theta) * std::sin(phi));
        }
    mesh.normals = mesh.positions;
    for (std::uint32_t i = 0; i < rings; ++i)
        for (std::uint32_t j = 0; j < around; ++j) {
            const std::uint32_t a = i * around + j, b = i * around + (j + 1) % around;
            mesh.triangles.push_back({a, a + around, b});
            mesh.triangles.push_back({b, a + around, b + around});
        }
    return mesh;
}

/// Mean of how far the triangles' own normals are from those of their corners, as cosine.
double agreement(const Mesh& mesh)
{
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3d own =
            normalized(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
        sum += dot(own, normalized(mesh.normals[a] + mesh.normals[b] + mesh.normals[c]));
    }
    return sum / static_cast<double>(mesh.triangles.size());
}

TEST(Clustered, HasAtMostAsManyTrianglesAsAllowedAndNotManyFewer)
{
    const Mesh mesh = ball(120); // 57600 triangles
    for (const std::size_t most : {20000U, 4000U, 300U}) {
        const Mesh coarse = clustered(mesh, most);
        EXPECT_LE(coarse.triangles.size(), most);
        EXPECT_GT(coarse.triangles.size(), most / 8);
    }
}

TEST(Clustered, StaysNearTheSurfaceAndTurnsOutwards)
{
    const Mesh coarse = clustered(ball(120), 6000);
    for (std::size_t i = 0; i < coarse.positions.size(); ++i) {
        // Means of points of a cell of about 1/12 lie inside the sphere by no more than its sagitta.
        EXPECT_LE(length(coarse.positions[i]), 1.0 + 1e-12);
        EXPECT_GT(length(coarse.positions[i]), 0.99);
        EXPECT_NEAR(length(coarse.normals[i]), 1.0, 1e-12);
        EXPECT_GT(dot(coarse.normals[i], normalized(coarse.positions[i])), 0.99);
    }
    EXPECT_GT(agreement(coarse), 0.9);
    for (const auto& [a, b, c] : coarse.triangles)
        EXPECT_GE(dot(cross(coarse.positions[b] - coarse.positions[a], coarse.positions[c] - coarse.positions[a]),
                      coarse.normals[a] + coarse.normals[b] + coarse.normals[c]),
                  0.0)
            << "a triangle that shows its back is dark";
    Mesh turned = coarse; // planted: the other winding must show
    for (Mesh::Triangle& triangle : turned.triangles)
        std::swap(triangle[1], triangle[2]);
    EXPECT_LT(agreement(turned), -0.9);
}

TEST(Clustered, KeepsBothSidesOfAThinWallApart)
{
    Mesh wall = ball(60);
    for (Vec3d& P : wall.positions)
        P.z *= 1e-3;
    wall.normals.clear();
    for (const Vec3d& P : ball(60).positions)
        wall.normals.push_back(normalized(Vec3d(P.x * 1e-3, P.y * 1e-3, P.z)));
    const Mesh coarse = clustered(wall, 2000);
    EXPECT_GT(std::count_if(coarse.normals.begin(), coarse.normals.end(), [](const Vec3d& N) { return N.z > 0.5; }),
              20);
    EXPECT_GT(std::count_if(coarse.normals.begin(), coarse.normals.end(), [](const Vec3d& N) { return N.z < -0.5; }),
              20);
}

/// Three faces of a cube that meet in a corner, each with its own normal.
Mesh corner()
{
    Mesh mesh;
    mesh.name = "corner";
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 4; ++i) {
            const double u = i % 2 == 0 ? 0.5 : -0.5, v = i < 2 ? 0.5 : -0.5;
            mesh.positions.push_back(axis == 0 ? Vec3d(0.5, u, v) : axis == 1 ? Vec3d(u, 0.5, v) : Vec3d(u, v, 0.5));
            mesh.normals.emplace_back(axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0);
        }
    for (std::uint32_t first : {0U, 4U, 8U}) {
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first + 1, first + 3, first + 2});
    }
    return mesh;
}

TEST(Clustered, LeavesASmallMeshWithItsSharpEdgesAsItIs)
{
    const Mesh coarse = clustered(corner(), 100000);
    EXPECT_EQ(coarse.triangles.size(), 6U);
    EXPECT_EQ(coarse.positions.size(), 12U);
    EXPECT_EQ(coarse.name, "corner");
    for (const Vec3d& N : coarse.normals)
        EXPECT_EQ(N.x + N.y + N.z, 1.0) << "no edge is rounded off";
}

TEST(Clustered, SurvivesWhatIsHardlyAMesh)
{
    EXPECT_EQ(clustered(Mesh(), 10).triangles.size(), 0U);
    Mesh flat = ball(20);
    for (Vec3d& N : flat.normals)
        N = {0.0, 0.0, 1.0};
    EXPECT_LE(clustered(flat, 1).triangles.size(), 1U);
}

} // namespace
} // namespace reflectance
