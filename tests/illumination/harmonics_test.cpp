// Nine harmonics against closed forms, and against what they are made for: the irradiance of a matte surface.
#include "core/illumination/harmonics.h"

#include "core/illumination/even_directions.h"

#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

/// The quadrature's own error on smooth functions, 20000 points: met were 7e-6.
constexpr double quadrature = 2e-5;

double largestDifference(const Harmonics& a, const Harmonics& b)
{
    double largest = 0.0;
    for (std::size_t k = 0; k < 9; ++k)
        for (const double d : {a[k].x - b[k].x, a[k].y - b[k].y, a[k].z - b[k].z})
            largest = std::max(largest, std::fabs(d));
    return largest;
}

TEST(Harmonics, AreOrthonormal)
{
    for (std::size_t k = 0; k < 9; ++k) {
        const Harmonics found = projected([k](const Vec3d& d) { return Vec3d(harmonicsAt(d)[k]); });
        Harmonics expected{};
        expected[k] = Vec3d(1.0);
        EXPECT_LE(largestDifference(found, expected), quadrature) << k;
    }
}

TEST(Harmonics, OfSimpleSurroundingsAreKnown)
{
    Harmonics constant{};
    constant[0] = Vec3d(0.5, 1.0, 2.0) * (2.0 * std::sqrt(pi));
    EXPECT_LE(largestDifference(projected([](const Vec3d&) { return Vec3d(0.5, 1.0, 2.0); }), constant), quadrature);
    // The upper half sphere alone: sqrt(pi) of order 0, sqrt(3 pi) / 2 of y, nothing of the second order.
    const Harmonics sky = projected([](const Vec3d& d) { return Vec3d(d.y > 0.0 ? 1.0 : 0.0); });
    EXPECT_NEAR(sky[0].x, std::sqrt(pi), 1e-3); // the edge falls between points
    EXPECT_NEAR(sky[1].x, std::sqrt(3.0 * pi) / 2.0, 1e-3);
    for (std::size_t k = 2; k < 9; ++k)
        EXPECT_NEAR(sky[k].x, 0.0, 1e-3) << k;
}

TEST(Harmonics, GiveBackWhatTheyHoldAndNothingBelowZero)
{
    const auto smooth = [](const Vec3d& d) { return Vec3d(1.0 + 0.3 * d.x + 0.2 * d.y * d.z, 1.0, 1.0 - 0.5 * d.y); };
    const Harmonics held = projected(smooth);
    const Environment drawn = environmentOf(held);
    const Harmonics dark = projected([](const Vec3d& d) { return Vec3d(d.y > 0.99 ? 1.0 : 0.0); });
    for (int i = 0; i < 500; ++i) {
        const Vec3d d = evenDirection(i, 500);
        EXPECT_LE(length(radianceOf(held, d) - smooth(d)), 1e-4);
        // Straight lines between texels of 2.8 degrees, and the rows beside the poles.
        EXPECT_LE(length(radianceFrom(drawn, d) - smooth(d)), 0.02);
        EXPECT_GE(radianceOf(dark, d).x, 0.0);
    }
}

/// The paper's claim, on the sky: E(N) by quadrature, and from nine numbers with A = pi, 2 pi / 3, pi / 4.
TEST(Harmonics, HoldWhatAMatteSurfaceSees)
{
    const auto sky = [](const Vec3d& d) { return Vec3d(0.2 + (d.y > 0.0 ? d.y : 0.0)); };
    const Harmonics held = projected(sky);
    const double A[] = {pi, 2.0 * pi / 3.0, pi / 4.0};
    double worst = 0.0, withoutSecond = 0.0, most = 0.0;
    for (int i = 0; i < 40; ++i) {
        const Vec3d N = evenDirection(i, 40);
        const auto weights = harmonicsAt(N);
        double nine = 0.0, four = 0.0;
        for (std::size_t k = 0; k < 9; ++k) {
            nine += A[k == 0 ? 0 : k < 4 ? 1 : 2] * weights[k] * held[k].x;
            four += k < 4 ? A[k == 0 ? 0 : 1] * weights[k] * held[k].x : 0.0;
        }
        double truth = 0.0;
        for (int j = 0; j < 4000; ++j) {
            const Vec3d d = evenDirection(j, 4000);
            truth += std::max(0.0, dot(N, d)) * sky(d).x * 4.0 * pi / 4000.0;
        }
        worst = std::max(worst, std::fabs(nine - truth));
        withoutSecond = std::max(withoutSecond, std::fabs(four - truth));
        most = std::max(most, truth);
    }
    EXPECT_LE(worst, 0.01 * most);
    EXPECT_GT(withoutSecond, 0.03 * most) << "the planted fault: four numbers are not enough";
}

} // namespace
} // namespace reflectance
