// The built-in studio: sane everywhere, equal in both precisions, and lit as a photographer would.
#include "core/illumination/environment.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace reflectance {
namespace {

/// Directions spread evenly over the sphere (golden-angle spiral).
std::vector<Vec3d> directions(int count)
{
    std::vector<Vec3d> all;
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / count;
        const double azimuth = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double r = std::sqrt(1.0 - y * y);
        all.emplace_back(r * std::cos(azimuth), y, r * std::sin(azimuth));
    }
    return all;
}

Vec3d studio(const Vec3d& d)
{
    return radianceFrom(Environment{}, d);
}

double largest(const Vec3d& v)
{
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// The steepest change per radian between each direction and one 1e-4 away from it.
template <class Radiance> double steepest(Radiance radiance)
{
    double slope = 0.0;
    for (const Vec3d& d : directions(50000)) {
        const Vec3d beside = normalized(d + 1e-4 * Vec3d(-d.z, 0.3, d.x));
        slope = std::max(slope, largest(radiance(beside) - radiance(d)) / length(beside - d));
    }
    return slope;
}

/// The steepest edge is the rim light's: 4 over a quarter of its half width of 0.17, times 3/2 for the cubic.
constexpr double steepestEdge = 160.0;

TEST(Studio, IsTheSurroundingsOfANewScene)
{
    EXPECT_EQ(Environment{}.kind, EnvironmentKind::Studio);
}

TEST(Studio, IsFiniteAndPositiveAndNotTooBright)
{
    for (const Vec3d& d : directions(100000)) {
        const Vec3d radiance = studio(d);
        ASSERT_TRUE(std::isfinite(radiance.x + radiance.y + radiance.z));
        ASSERT_GT(std::min({radiance.x, radiance.y, radiance.z}), 0.0);
        ASSERT_LT(largest(radiance), 7.0);
    }
}

TEST(Studio, SurvivesTheAxesAndTheHorizon)
{
    for (const Vec3d& d : {Vec3d{0, 1, 0}, Vec3d{0, -1, 0}, Vec3d{1, 0, 0}, Vec3d{0, 0, 1}, Vec3d{0.8, -1e-300, 0.6}})
        EXPECT_TRUE(std::isfinite(largest(studio(d))));
}

TEST(Studio, HasSoftEdgesOnly)
{
    EXPECT_LT(steepest(studio), steepestEdge);
}

TEST(Studio, AHardEdgeWouldBeFound)
{
    EXPECT_GT(steepest([](const Vec3d& d) { return Vec3d(d.y > 0.0 ? 1.0 : 0.0); }), steepestEdge);
}

TEST(Studio, FloatSeesWhatDoubleSees)
{
    for (const Vec3d& d : directions(100000)) {
        const Vec3d inFloat(radianceFrom(Environment{}, Vec3f(d)));
        // A direction rounded by 6e-8 per component meets the steepest edge; twice that for the arithmetic.
        ASSERT_LT(largest(inFloat - studio(d)), 3 * 6e-8 * steepestEdge);
    }
}

TEST(Studio, TheKeyLightStandsUpLeftInFront)
{
    const auto all = directions(20000);
    const Vec3d brightest = *std::max_element(
        all.begin(), all.end(), [](const Vec3d& a, const Vec3d& b) { return largest(studio(a)) < largest(studio(b)); });
    EXPECT_LT(brightest.x, 0.0);
    EXPECT_GT(brightest.y, 0.0);
    EXPECT_GT(brightest.z, 0.0);
    EXPECT_GT(largest(studio(brightest)), 5.0);
}

TEST(Studio, TheFloorIsDarkerThanTheCove)
{
    EXPECT_LT(largest(studio(normalized(Vec3d{0.1, -1, 0.13}))), largest(studio(normalized(Vec3d{0, 0.1, -1}))) / 3.0);
}

TEST(Studio, TheFloorCarriesAGrid)
{
    // On the plane y = -1.2, a line of radiance 0.055 passes at x = 0.3, and the square's middle lies below the object.
    const Vec3d line = studio(normalized(Vec3d{0.3, -1.2, 0.0}));
    const Vec3d square = studio(normalized(Vec3d{0.15, -1.2, 0.0}));
    EXPECT_GT(line.y, square.y + 0.05);
}

} // namespace
} // namespace reflectance
