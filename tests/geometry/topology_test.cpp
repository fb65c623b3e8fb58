#include "core/geometry/topology.h"
#include "tests/geometry/mesh_text.h"

#include <gtest/gtest.h>

namespace reflectance::testing {
namespace {

TopologySummary summaryOf(const std::string& text)
{
    return Topology(*loaded(text).mesh).summary();
}

/// The cube without the face that stands `removed`-th.
std::string cubeWithout(std::size_t removed)
{
    std::string text = cubeVertices();
    for (std::size_t q = 0; q < cubeQuads().size(); ++q) {
        if (q == removed)
            continue;
        text += "f";
        for (const int corner : cubeQuads()[q])
            text += " " + std::to_string(corner + 1);
        text += "\n";
    }
    return text;
}

TEST(Topology, OfAClosedCube)
{
    const TopologySummary cube = summaryOf(cubeVertices() + cubeFaces());
    EXPECT_TRUE(cube.isClosed());
    EXPECT_EQ(cube.vertices, 8U) << "split at its creases, and yet one solid";
    EXPECT_EQ(cube.edges, 18U);
    EXPECT_EQ(cube.components, 1U);
    EXPECT_EQ(cube.eulerCharacteristic(), 2);
    EXPECT_EQ(cube.separatedTriangles, 0U);
}

TEST(Topology, OfACubeWithoutLid)
{
    const Topology open(*loaded(cubeWithout(1)).mesh);
    EXPECT_FALSE(open.summary().isClosed());
    EXPECT_EQ(open.summary().boundaryEdges, 4U);
    ASSERT_EQ(open.boundaryLoops().size(), 1U);
    EXPECT_EQ(open.boundaryLoops()[0].size(), 4U);
}

TEST(Topology, CountsPieces)
{
    const std::string two = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n";
    EXPECT_EQ(summaryOf(two).components, 2U);
    EXPECT_EQ(summaryOf(two).boundaryLoops, 2U);
    const std::string touching = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n";
    EXPECT_EQ(summaryOf(touching).components, 2U) << "a common vertex does not join pieces, a common edge does";
}

TEST(Topology, SeesEdgesWithThreeTriangles)
{
    const std::string fin = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";
    const TopologySummary summary = summaryOf(fin);
    EXPECT_EQ(summary.nonManifoldEdges, 1U);
    EXPECT_EQ(summary.triangles, 3U) << "nothing is lost";
    EXPECT_GE(summary.separatedTriangles, 1U) << "the half-edge structure cannot hold the third on the same edge";
}

TEST(Topology, SeesNeighboursWoundAgainstEachOther)
{
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    EXPECT_EQ(summaryOf(vertices + "f 1 2 3\nf 1 3 4\n").windingConflicts, 0U);
    EXPECT_EQ(summaryOf(vertices + "f 1 2 3\nf 1 4 3\n").windingConflicts, 1U) << "the planted fault";
}

TEST(Topology, OfATorusIsThatOfATorus)
{
    std::string text;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k) {
            const double a = i * 0.7853981633974483;
            const double b = k * 0.7853981633974483;
            const double radius = 2.0 + std::cos(b);
            text += "v " + std::to_string(radius * std::cos(a)) + " " + std::to_string(std::sin(b)) + " " +
                    std::to_string(radius * std::sin(a)) + "\n";
        }
    const auto id = [](int i, int k) { return " " + std::to_string((i % 8) * 8 + k % 8 + 1); };
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k)
            text += "f" + id(i, k) + id(i, k + 1) + id(i + 1, k + 1) + id(i + 1, k) + "\n";
    const TopologySummary torus = summaryOf(text);
    EXPECT_TRUE(torus.isClosed());
    EXPECT_EQ(torus.eulerCharacteristic(), 0);
}

} // namespace
} // namespace reflectance::testing
