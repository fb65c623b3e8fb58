// The angles that weigh smooth normals.
#include "core/geometry/corner_angles.h"
#include "core/geometry/triangle_loops.h"

#include <cstring>
#include <gmock/gmock.h>
#include <numbers>
#include <random>

namespace reflectance::testing {
namespace {

using std::numbers::pi;

constexpr double unit = std::numeric_limits<double>::epsilon();

Vec3d randomPoint(std::mt19937& random)
{
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
    return {coordinate(random), coordinate(random), coordinate(random)};
}

/// The largest error of angleOf over many ratios of either sign, in units of the last place of the result.
double worstOf(double (*angle)(double, double))
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-60.0, 60.0);
    std::uniform_real_distribution<double> near(-2.0, 2.0);
    double worst = 0.0;
    for (int i = 0; i < 200'000; ++i) {
        const double sine = std::exp2(i % 2 == 0 ? exponent(random) : near(random));
        const double cosine = i % 4 < 2 ? 1.0 : -1.0;
        const long double exact = std::atan2(static_cast<long double>(sine), static_cast<long double>(cosine));
        const long double last = std::exp2(std::floor(std::log2(exact))) * static_cast<long double>(unit);
        worst = std::max(worst,
                         static_cast<double>(std::fabs(static_cast<long double>(angle(sine, cosine)) - exact) / last));
    }
    return worst;
}

TEST(CornerAngles, AreArctangentsToTheLastPlaces)
{
    EXPECT_LE(worstOf(angleOf), 3.0); // the promise of the header: a quotient, a polynomial and up to two differences
    EXPECT_GT(worstOf([](double s, double c) { return angleOf(s, c) * (1.0 + 8.0 * unit); }), 3.0) << "a planted error";
    EXPECT_EQ(angleOf(0.0, 1.0), 0.0);
    EXPECT_EQ(angleOf(0.0, -1.0), pi);
    EXPECT_EQ(angleOf(1.0, 0.0), 0.5 * pi);
}

TEST(CornerAngles, OfATriangleAddUpToPi)
{
    std::mt19937 random(3);
    std::vector<Vec3d> positions;
    std::vector<Mesh::Triangle> triangles;
    for (std::uint32_t i = 0; i < 3000; i += 3) {
        for (int k = 0; k < 3; ++k)
            positions.push_back(randomPoint(random));
        triangles.push_back({i, i + 1, i + 2});
    }
    // A side of length s is known to a unit and its direction to a unit over s; of these none is below a hundredth.
    for (const auto& [a, b, c] : cornerAngles(positions, triangles))
        EXPECT_NEAR(a + b + c, pi, 200.0 * unit);
}

TEST(CornerAngles, OfNeedlesKeepTheirDigits) // hazard H16: an arc cosine would see 0 at the tip
{
    const std::vector<Vec3d> needle{{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}};
    const auto angles = cornerAngles(needle, std::vector<Mesh::Triangle>{{0, 1, 2}});
    EXPECT_NEAR(angles[0][0], 1e-9, 1e-9 * 4.0 * unit); // atan(x) is x here; a few roundings
    EXPECT_NEAR(angles[0][1], 0.5 * pi, 4.0 * unit);
}

TEST(CornerAngles, DoNotDependOnTheSize)
{
    for (const double size : {1e-300, 1e-100, 1e100, 1e300}) {
        const std::vector<Vec3d> corners{{0, 0, 0}, {size, 0, 0}, {0, 3.0 * size, 0}};
        const auto angles = cornerAngles(corners, std::vector<Mesh::Triangle>{{0, 1, 2}});
        EXPECT_NEAR(angles[0][0], 0.5 * pi, 4.0 * unit) << size; // a few roundings, here and below
        EXPECT_NEAR(angles[0][1], std::atan2(3.0, 1.0), 8.0 * unit) << size;
        EXPECT_NEAR(angles[0][2], std::atan2(1.0, 3.0), 8.0 * unit) << size;
    }
}

TEST(CornerAngles, DoNotDependOnTheNumberOfThreads)
{
    std::mt19937 random(5);
    std::vector<Vec3d> positions;
    for (int i = 0; i < 1000; ++i)
        positions.push_back(randomPoint(random));
    std::vector<Mesh::Triangle> triangles;
    std::uniform_int_distribution<std::uint32_t> vertex(0, 996);
    for (int i = 0; i < 40'000; ++i) { // more than one thread takes at a time
        const std::uint32_t v = vertex(random);
        triangles.push_back({v, v + 1, v + 3});
    }
    const auto alone = cornerAngles(positions, triangles);
    const auto together = cornerAngles(positions, triangles, 5);
    EXPECT_EQ(std::memcmp(alone.data(), together.data(), alone.size() * sizeof alone[0]), 0);
}

/// NaN included, which equals nothing.
template <class T> bool haveSameBits(const T& a, const T& b)
{
    return std::memcmp(static_cast<const void*>(&a), static_cast<const void*>(&b), sizeof a) == 0;
}

/// Every processor has the same mesh: what lanes of two and of four give for a block is what one gives.
TEST(TriangleLoops, GiveTheSameBitsInEveryLane)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> exponent(-40.0, 40.0);
    AngleBlock angles[2];
    NormalBlock normals[2];
    for (int round = 0; round < 200; ++round) {
        TriangleBlock block;
        for (auto& corner : block.coordinates)
            for (auto& axis : corner)
                for (double& number : axis)
                    number = round % 2 == 0 ? randomPoint(random).x : std::exp2(exponent(random));
        block.coordinates[1][0][0] = std::numeric_limits<double>::quiet_NaN();
        triangleLoopsSse2().angles(block, angles[0]);
        triangleLoopsSse2().normals(block, normals[0]);
        triangleLoops().angles(block, angles[1]);
        triangleLoops().normals(block, normals[1]);
        EXPECT_TRUE(haveSameBits(angles[0], angles[1]));
        EXPECT_TRUE(haveSameBits(normals[0], normals[1]));
        for (std::size_t i = 1; i < TriangleBlock::capacity; ++i) {
            const TriangleSides<double> sides = block.sides(i);
            const Vec3d n = sides.normal();
            ASSERT_EQ(angles[0].angles[0][i], angleOf(std::sqrt(dot(n, n)), dot(sides.ab, sides.ac)));
            ASSERT_EQ(normals[0].normals[1][i], n.y / std::sqrt(dot(n, n)));
            ASSERT_EQ(normals[0].sizes[i], sides.size());
        }
    }
    normals[1].normals[2][5] = std::nextafter(normals[1].normals[2][5], 2.0);
    EXPECT_FALSE(haveSameBits(normals[0], normals[1])) << "a planted bit";
}

} // namespace
} // namespace reflectance::testing
