// Normals that the file does not give, or gives badly.
#include "core/geometry/assemble.h"
#include "core/geometry/normals.h"
#include "core/geometry/readers.h"
#include "tests/geometry/mesh_text.h"

#include <cstring>
#include <gmock/gmock.h>
#include <map>
#include <numbers>

namespace reflectance::testing {
namespace {

double largestAngleToPosition(const Mesh& mesh)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        largest = std::max(largest, length(mesh.normals[i] - normalized(mesh.positions[i])));
    return largest;
}

TEST(Normals, OfASphereAreItsPositions)
{
    const LoadedMesh coarse = loaded(sphereObj(24, 48));
    const LoadedMesh fine = loaded(sphereObj(96, 192));
    EXPECT_EQ(fine.mesh->positions.size(), fine.report.fileVertices) << "a smooth surface is split nowhere";
    // The error of angle-weighted normals falls with the square of the facet: (pi/96)^2 is 1.1e-3, and a factor 4 finer
    // must be about 16 times better.
    EXPECT_LT(largestAngleToPosition(*fine.mesh), 1.1e-3);
    EXPECT_LT(largestAngleToPosition(*fine.mesh), largestAngleToPosition(*coarse.mesh) / 8.0);
}

TEST(Normals, OfACubeAreItsFaces)
{
    const LoadedMesh cube = loaded(cubeVertices() + cubeFaces());
    EXPECT_EQ(cube.mesh->positions.size(), 24U);
    for (const Mesh::Triangle& t : cube.mesh->triangles) {
        const auto& p = cube.mesh->positions;
        const Vec3d face = normalized(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
        for (const std::uint32_t v : t)
            EXPECT_NEAR(length(cube.mesh->normals[v] - face), 0.0, 1e-15); // one rounding of each component
    }
}

TEST(Normals, ACubeWithoutCreasesIsTheSameFromAllSides)
{
    LoadOptions options;
    options.creaseAngleDegrees = 180.0;
    const LoadedMesh cube = loaded(cubeVertices() + cubeFaces(), "cube.obj", options);
    EXPECT_EQ(cube.mesh->positions.size(), 8U);
    // Weighted by angle, the diagonals of the quads do not matter: each normal is the diagonal of the cube. Weights by
    // count or area would miss it by 0.1 and more.
    EXPECT_LT(largestAngleToPosition(*cube.mesh), 1e-15);
}

TEST(Normals, TheCreaseAngleDecides)
{
    // Two unit squares that bend by 30 degrees along their common edge.
    const double c = std::cos(std::numbers::pi / 6.0);
    const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv " + std::to_string(1.0 + c) + " 0 -0.5\nv " +
                             std::to_string(1.0 + c) + " 1 -0.5\nf 1 2 3 4\nf 2 5 6 3\n";
    LoadOptions sharp;
    sharp.creaseAngleDegrees = 29.0;
    LoadOptions smooth;
    smooth.creaseAngleDegrees = 31.0;
    EXPECT_EQ(loaded(text, "a.obj", sharp).mesh->positions.size(), 8U);
    EXPECT_EQ(loaded(text, "a.obj", smooth).mesh->positions.size(), 6U);
}

TEST(Normals, SeamsOfSplitVerticesStaySmooth)
{
    std::string text;
    const LoadedMesh whole = loaded(sphereObj(12, 24));
    for (const Mesh::Triangle& t : whole.mesh->triangles)
        for (const std::uint32_t v : t) {
            const Vec3d& p = whole.mesh->positions[v];
            text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
        }
    for (std::size_t i = 0; i < whole.mesh->triangles.size(); ++i)
        text +=
            "f " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + " " + std::to_string(3 * i + 3) + "\n";
    const LoadedMesh soup = loaded(text);
    EXPECT_NEAR(largestAngleToPosition(*soup.mesh), largestAngleToPosition(*whole.mesh),
                1e-5); // six decimals were written
}

TEST(Normals, BadOnesAreReplacedAndCounted) // hazard H13
{
    const LoadedMesh m = loaded("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan 0 1\nvn inf 0 0\nvn 0 0 0\nf 1//1 2//2 3//3\n");
    EXPECT_EQ(m.report.cornersWithBadNormal, 3U);
    EXPECT_EQ(m.report.cornersWithComputedNormal, 3U);
    for (const Vec3d& normal : m.mesh->normals)
        EXPECT_EQ(normal, Vec3d(0, 0, 1));
}

TEST(Normals, TinyAndHugeOnesAreDirectionsToo) // hazards H10 to H12
{
    const LoadedMesh m =
        loaded("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 5e-324\nvn 0 0 1e308\nvn 3e-200 0 4e-200\nf 1//1 2//2 3//3\n");
    EXPECT_EQ(m.report.cornersWithBadNormal, 0U);
    EXPECT_EQ(m.mesh->normals[0], Vec3d(0, 0, 1));
    EXPECT_EQ(m.mesh->normals[1], Vec3d(0, 0, 1));
    EXPECT_NEAR(m.mesh->normals[2].x, 0.6, 1e-15); // a few roundings of one component
}

TEST(Normals, ThatCancelGiveWayToTheFace) // hazard H14
{
    LoadOptions options;
    options.creaseAngleDegrees = 180.0;
    const LoadedMesh twoSided = loaded("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n", "a.obj", options);
    ASSERT_EQ(twoSided.mesh->triangles.size(), 2U);
    for (std::size_t t = 0; t < 2; ++t)
        for (const std::uint32_t v : twoSided.mesh->triangles[t])
            EXPECT_EQ(twoSided.mesh->normals[v], Vec3d(0, 0, t == 0 ? 1 : -1));
}

TEST(Normals, OfTinyTrianglesAreExactAndThoseWithoutAreaHaveNone) // hazard H15
{
    EXPECT_EQ(faceNormal({0, 0, 0}, {1e-30, 0, 0}, {0, 1e-30, 0}), Vec3d(0, 0, 1));
    EXPECT_EQ(faceNormal({0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}), Vec3d(0, 0, 1));
    EXPECT_EQ(faceNormal({0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}), Vec3d(0, 0, 1));
    EXPECT_EQ(faceNormal({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), Vec3d());
    EXPECT_EQ(faceNormal({1, 2, 3}, {1, 2, 3}, {4, 5, 6}), Vec3d());
    EXPECT_EQ(faceNormal({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.7, 0.7, 0.7}), Vec3d()) << "a line but for rounding";
    EXPECT_EQ(faceNormal({0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}), Vec3d(0, 0, 1)) << "a needle is a triangle";
}

TEST(Normals, TrianglesWithoutAreaLeaveTheOthersAlone)
{
    const std::string plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\n";
    const LoadedMesh m = loaded(plain + "f 1 2 4\nf 1 1 2\n");
    EXPECT_EQ(m.report.degenerateTriangles, 1U);
    EXPECT_EQ(m.report.droppedFaces(), 1U);
    for (const Vec3d& normal : m.mesh->normals)
        EXPECT_EQ(normal, Vec3d(0, 0, 1));
}

TEST(Normals, ATriangleWoundAgainstItsNormalsIsTurnedOver)
{
    const LoadedMesh m = loaded("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(m.report.flippedTriangles, 1U);
    const auto& p = m.mesh->positions;
    const Mesh::Triangle& t = m.mesh->triangles[0];
    EXPECT_LT(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]).z, 0.0) << "winding and normals agree afterwards";
    EXPECT_EQ(m.mesh->normals[0], Vec3d(0, 0, -1));
}

TEST(Normals, CanBeComputedAnewOnRequest)
{
    LoadOptions options;
    options.recomputeNormals = true;
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 1\nf 1//1 2//1 3//1\n";
    EXPECT_NE(loaded(text).mesh->normals[0], Vec3d(0, 0, 1)) << "the planted normal, kept without the option";
    EXPECT_EQ(loaded(text, "a.obj", options).mesh->normals[0], Vec3d(0, 0, 1));
}

/// The mesh's normals as so many threads compute them.
std::vector<Vec3d> smoothedBy(int threads, const std::string& text)
{
    ReadContext context;
    context.threads = threads;
    MeshReport report;
    auto soup = readObj(TextParts(text), context);
    auto list = trianglesOf(*soup, context, report);
    CornerNormals normals = fileNormals(*soup, *list, report, threads);
    smoothMissingNormals(*soup, *list, 55.0, normals, report, threads);
    return assembled(*soup, *std::move(list), normals, report).normals;
}

TEST(Normals, DoNotDependOnTheNumberOfThreads)
{
    const std::string text = sphereObj(180, 250); // more vertices than one thread takes at a time
    const std::vector<Vec3d> alone = smoothedBy(1, text);
    ASSERT_GT(alone.size(), 40000U);
    for (const int threads : {2, 5}) {
        const std::vector<Vec3d> together = smoothedBy(threads, text);
        ASSERT_EQ(together.size(), alone.size());
        EXPECT_EQ(std::memcmp(together.data(), alone.data(), alone.size() * sizeof(Vec3d)), 0) << threads;
    }
}

} // namespace
} // namespace reflectance::testing
