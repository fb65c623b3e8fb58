// What lies at a vertex: which others share its place, which corners meet there, whether one normal will do.
#include "core/geometry/corner_angles.h"
#include "core/geometry/corners_around.h"
#include "core/geometry/readers.h"
#include "core/geometry/vertex_smoother.h"
#include "core/geometry/weld.h"
#include "tests/geometry/mesh_text.h"

#include <gmock/gmock.h>
#include <map>
#include <numeric>
#include <tuple>

namespace reflectance::testing {
namespace {

using Index = std::uint32_t;

TEST(Weld, FindsTheFirstOfEqualPositionsWhateverTheNumberOfThreads)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::mt19937 random(11);
    std::uniform_int_distribution<int> coordinate(-12, 12);
    std::vector<Vec3d> positions{{0.0, 1.0, 2.0}, {-0.0, 1.0, 2.0}, {nan, 0, 0}, {nan, 0, 0}};
    for (int i = 0; i < 150'000; ++i) // more than one thread takes at a time, and several at most places
        positions.emplace_back(coordinate(random), 0.1 * coordinate(random), 1e-300 * coordinate(random));
    std::map<std::tuple<double, double, double>, Index> firsts;
    std::vector<Index> expected;
    for (Index i = 0; i < positions.size(); ++i) {
        const Vec3d& p = positions[i];
        expected.push_back(std::isnan(p.x) ? i : firsts.try_emplace({p.x, p.y, p.z}, i).first->second);
    }
    for (const int threads : {1, 2, 5})
        EXPECT_EQ(firstAtSamePlace(positions, threads), expected) << threads;
    EXPECT_EQ(expected[1], 0U) << "0 and -0 are equal";
    EXPECT_TRUE(firstAtSamePlace({}).empty());
}

TEST(CornersAround, ListsEveryVertexsCornersAscendingWhateverTheNumberOfThreads)
{
    constexpr Index vertices = 500;
    std::mt19937 random(13);
    std::uniform_int_distribution<Index> vertex(0, vertices - 1);
    std::vector<Mesh::Triangle> triangles(300'000); // worth several threads
    for (Mesh::Triangle& triangle : triangles)
        triangle = {vertex(random), vertex(random), vertex(random)};
    std::vector<Index> vertexOf(vertices);
    std::iota(vertexOf.begin(), vertexOf.end(), 0U);
    vertexOf[7] = 3;
    const CornersAround alone = cornersAround(triangles, vertexOf);
    EXPECT_EQ(alone.corners.size(), 3 * triangles.size());
    EXPECT_TRUE(alone.of(7).empty()) << "its corners are those of 3";
    for (Index v = 0; v < vertices; ++v) {
        EXPECT_TRUE(std::is_sorted(alone.of(v).begin(), alone.of(v).end()));
        for (const Index corner : alone.of(v))
            EXPECT_EQ(vertexOf[triangles[corner / 3][corner % 3]], v);
    }
    const CornersAround together = cornersAround(triangles, vertexOf, 3);
    EXPECT_EQ(together.ends, alone.ends);
    EXPECT_EQ(together.corners, alone.corners);
}

/// For every vertex that has corners: the normal that is soon seen, and all that the long way gives.
void eachVertex(const std::string& obj, double crease,
                const std::function<void(const std::optional<Vec3d>&, const std::vector<Vec3d>&)>& visit)
{
    ReadContext context;
    MeshReport report;
    auto soup = readObj(TextParts(obj), context);
    const auto list = trianglesOf(*soup, context, report);
    const auto vertexOf = firstAtSamePlace(soup->positions);
    const auto around = cornersAround(list->vertices, vertexOf);
    const auto angles = cornerAngles(soup->positions, list->vertices);
    const SmoothedMesh mesh{*list, vertexOf, angles, std::cos(crease * std::numbers::pi / 180.0)};
    VertexSmoother smoother(mesh);
    constexpr Index none = PolygonSoup::none;
    for (std::size_t v = 0; v < around.vertices(); ++v) {
        if (around.of(v).empty())
            continue;
        std::vector<Mesh::Triangle> corners(list->vertices.size(), {none, none, none});
        std::vector<Vec3d> fresh;
        smoother.smooth(around.of(v), corners, fresh);
        visit(smoother.oneNormal(around.of(v)), fresh);
    }
}

std::size_t soonSeenIn(const std::string& obj, double crease)
{
    std::size_t count = 0;
    eachVertex(obj, crease, [&](const std::optional<Vec3d>& one, const std::vector<Vec3d>& fresh) {
        ASSERT_FALSE(fresh.empty());
        if (one) {
            ++count;
            EXPECT_EQ(fresh.size(), 1U);
            EXPECT_EQ(*one, fresh[0]) << "to the bit";
        }
    });
    return count;
}

TEST(VertexSmoother, TheQuickWayGivesWhatTheLongOneGives)
{
    // All vertices of a sphere but the poles, where 24 triangles meet, too many for it.
    EXPECT_EQ(soonSeenIn(sphereObj(12, 24), 55.0), 11U * 24U);
    EXPECT_EQ(soonSeenIn(cubeVertices() + cubeFaces(), 55.0), 0U) << "creases at every vertex";
    EXPECT_EQ(soonSeenIn(cubeVertices() + cubeFaces(), 100.0), 8U) << "no creases any more";
}

TEST(VertexSmoother, FansThatOnlyMeetAtAVertexStayApart)
{
    // Two flat squares of two triangles each, corner to corner: the middle has one normal of each.
    const std::string bow = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 0 0\nv -1 -1 0\nv 0 -1 0\n"
                            "f 1 2 3\nf 1 3 4\nf 1 5 6\nf 1 6 7\n";
    EXPECT_EQ(soonSeenIn(bow, 55.0), 6U) << "all but the middle";
}

TEST(VertexSmoother, AnOpenFanIsWalkedBothWaysFromItsMiddle)
{
    const std::string fan = "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nv -1 1 0\n"
                            "f 1 3 4\nf 1 2 3\nf 1 4 5\n";
    EXPECT_EQ(soonSeenIn(fan, 55.0), 5U);
}

} // namespace
} // namespace reflectance::testing
