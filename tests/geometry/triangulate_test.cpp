#include "core/geometry/triangulate.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace reflectance::testing {
namespace {

using Polygon = std::vector<Vec3d>;

/// Sum of the triangles' unsigned areas: too large when they overlap or leave the polygon.
double areaOfTriangles(const Polygon& polygon)
{
    double area = 0.0;
    for (const auto& [a, b, c] : triangulated(polygon))
        area += 0.5 * length(cross(polygon[b] - polygon[a], polygon[c] - polygon[a]));
    return area;
}

/// By the surveyor's formula, without any triangles.
double areaOfPolygon(const Polygon& polygon)
{
    Vec3d sum;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return 0.5 * length(sum);
}

void expectExactCover(const Polygon& polygon, const char* what)
{
    EXPECT_EQ(triangulated(polygon).size(), polygon.size() - 2) << what;
    const double area = areaOfPolygon(polygon);
    // Each of the n triangles rounds its area a few times.
    const double tolerance = 1e-15 * static_cast<double>(polygon.size()) * area + 1e-13 * area;
    EXPECT_NEAR(areaOfTriangles(polygon), area, tolerance) << what;
    Vec3d orientation;
    for (const auto& [a, b, c] : triangulated(polygon))
        orientation += cross(polygon[b] - polygon[a], polygon[c] - polygon[a]);
    EXPECT_NEAR(0.5 * length(orientation), area, tolerance) << what << ": some triangle is turned over";
}

Polygon star(std::size_t points, double inner)
{
    Polygon polygon;
    for (std::size_t i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
        const double radius = i % 2 == 0 ? 1.0 : inner;
        polygon.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
    }
    return polygon;
}

/// A comb: many deep notches, the classic trouble of fans.
Polygon comb(std::size_t teeth)
{
    Polygon polygon{{0, 0, 0}, {static_cast<double>(2 * teeth), 0, 0}};
    for (std::size_t i = teeth; i-- > 0;) {
        const double x = 2.0 * static_cast<double>(i);
        polygon.insert(polygon.end(), {{x + 2.0, 9, 0}, {x + 1.5, 9, 0}, {x + 1.0, 1, 0}, {x + 0.5, 9, 0}});
    }
    polygon.push_back({0, 9, 0});
    return polygon;
}

/// A band that winds inwards: nearly every corner lies near some ear.
Polygon spiral(std::size_t steps)
{
    Polygon polygon;
    const auto point = [](double turn, double radius) {
        return Vec3d{radius * std::cos(turn), radius * std::sin(turn), 0.0};
    };
    for (std::size_t i = 0; i < steps; ++i)
        polygon.push_back(point(0.03 * static_cast<double>(i), 1.0 + 0.003 * static_cast<double>(i)));
    for (std::size_t i = steps; i-- > 0;)
        polygon.push_back(point(0.03 * static_cast<double>(i), 0.6 + 0.003 * static_cast<double>(i)));
    return polygon;
}

TEST(Triangulate, CoversSimplePolygonsExactly)
{
    expectExactCover({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, "square");
    expectExactCover({{0, 0, 0}, {2, 0, 0}, {0.4, 0.4, 0}, {0, 2, 0}}, "concave quad");
    expectExactCover({{2, 0, 0}, {0.4, 0.4, 0}, {0, 2, 0}, {0, 0, 0}}, "concave quad, begun elsewhere");
    expectExactCover({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}}, "C");
    expectExactCover({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},
                     "corners on straight edges");
    expectExactCover(star(5, 0.3), "star");
    expectExactCover(comb(20), "comb");
    expectExactCover(spiral(300), "spiral");
}

TEST(Triangulate, HoldsInEveryPlaneAndSize)
{
    const Polygon flat = star(7, 0.4);
    for (const double scale : {1e-150, 1e-12, 1.0, 1e12, 1e150})
        for (int turn = 0; turn < 6; ++turn) {
            Polygon turned;
            for (const Vec3d& p : flat) {
                const double c[3] = {scale * p.x, scale * p.y, scale * (0.3 * p.x - 0.7 * p.y)};
                const int a = turn % 3;
                turned.push_back({c[a], c[(a + 1) % 3], c[(a + 2) % 3]});
            }
            if (turn >= 3)
                std::reverse(turned.begin(), turned.end());
            // Areas are compared as ratios: their own squares leave the range of double.
            Polygon unit = turned;
            for (Vec3d& p : unit)
                p = p / scale;
            EXPECT_EQ(triangulated(turned), triangulated(unit)) << scale;
            expectExactCover(unit, "turned star");
        }
}

TEST(Triangulate, AHoleJoinedByABridgeStaysAHole)
{
    // A square of area 16 with a square hole of area 4; the bridge runs along (0,0)-(1,1) and back.
    const Polygon polygon{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                          {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    EXPECT_NEAR(areaOfTriangles(polygon), 12.0, 1e-14);
}

TEST(Triangulate, CrossingPolygonsEndToo)
{
    const Polygon bow{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {-1, 1, 0}};
    EXPECT_EQ(triangulated(bow).size(), 3U);
    Polygon pentagram = star(5, 1.0);
    Polygon crossed;
    for (std::size_t i = 0; i < 10; ++i)
        crossed.push_back(pentagram[4 * i % 10]);
    EXPECT_EQ(triangulated(crossed).size(), 8U);
    EXPECT_EQ(triangulated(Polygon(50)).size(), 48U) << "all corners at one point";
    EXPECT_TRUE(triangulated(Polygon(2)).empty());
}

TEST(Triangulate, AHundredThousandCornersAreNoTrouble)
{
    expectExactCover(star(50'000, 0.5), "a star of 100 000 corners");
    expectExactCover(comb(25'000), "a comb of 100 000 corners");
    expectExactCover(spiral(50'000), "a spiral of 100 000 corners");
}

TEST(Triangulate, AFanWouldFailThisTest)
{
    const Polygon polygon = star(5, 0.3);
    double fan = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        fan += 0.5 * length(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]));
    EXPECT_GT(fan, 1.2 * areaOfPolygon(polygon)) << "the planted fault, which expectExactCover must not accept";
}

} // namespace
} // namespace reflectance::testing
