// Spectra between and beyond their samples, and the grid that integrates them.
#include "core/spectra/wavelength_grid.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

Spectrum table(std::vector<double> nm, std::vector<double> values, Outside outside = Outside::Zero)
{
    Spectrum spectrum;
    spectrum.nm = std::move(nm);
    spectrum.values = std::move(values);
    spectrum.outside = outside;
    return spectrum;
}

Spectrum gaussian(double center, double deviation)
{
    Spectrum spectrum;
    spectrum.bands = {{center, deviation, 1.0}};
    return spectrum;
}

double integral(const WavelengthGrid& grid, const Spectrum& a, const Spectrum& b)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < grid.size(); ++k)
        sum += grid.weight[k] * a.at(grid.nm[k]) * b.at(grid.nm[k]);
    return sum;
}

TEST(Spectrum, IsLinearBetweenSamplesAndExactAtThem)
{
    const Spectrum s = table({400, 500, 510}, {1, 3, 2});
    EXPECT_EQ(s.at(400), 1.0);
    EXPECT_EQ(s.at(450), 2.0);
    EXPECT_EQ(s.at(500), 3.0);
    EXPECT_EQ(s.at(505), 2.5);
    EXPECT_EQ(s.at(510), 2.0);
}

TEST(Spectrum, BeyondItsSamplesALightIsDarkAndASurfaceGoesOn)
{
    const Spectrum light = table({400, 500}, {1, 3});
    EXPECT_EQ(light.at(399.999), 0.0);
    EXPECT_EQ(light.at(500.001), 0.0);
    const Spectrum surface = table({400, 500}, {1, 3}, Outside::Nearest);
    EXPECT_EQ(surface.at(0.0), 1.0);
    EXPECT_EQ(surface.at(1e6), 3.0);
}

TEST(Spectrum, ABandIsAGaussian)
{
    const Spectrum s = gaussian(550, 20);
    EXPECT_EQ(s.at(550), 1.0);
    EXPECT_DOUBLE_EQ(s.at(570), std::exp(-0.5));
    EXPECT_EQ(s.at(550 + 161), 0.0);
    EXPECT_EQ(s.range().from, 550 - 160);
}

TEST(Spectrum, BandsOfALightAddUpToIt)
{
    const Spectrum light = table({380, 485, 490, 495, 580, 780}, {1, 7, 2, 5, 3, 4});
    const SpectrumTriple parts = dividedIntoBands(light);
    for (double nm = 380; nm <= 780; nm += 0.25)
        // Three products and two sums of numbers up to 7.
        EXPECT_NEAR(parts[0].at(nm) + parts[1].at(nm) + parts[2].at(nm), light.at(nm), 1e-14) << nm;
    EXPECT_EQ(parts[2].at(500), 0.0);
    EXPECT_EQ(parts[1].at(480), 0.0);
    EXPECT_EQ(parts[1].at(590), 0.0);
    EXPECT_EQ(parts[0].at(570), 0.0);
}

TEST(WavelengthGrid, IsExactForProductsOfTables)
{
    // x^2 and x (1 - x) on 0 .. 1, by hand: 1/3 and 1/6. The knot at 0.3 must not matter.
    const Spectrum rise = table({0, 1}, {0, 1});
    const Spectrum fall = table({0, 0.3, 1}, {1, 0.7, 0});
    const WavelengthGrid grid = gridThrough({0, 0.3, 1}, {0, 1}, 1);
    EXPECT_EQ(grid.size(), 6U);
    EXPECT_NEAR(integral(grid, rise, rise), 1.0 / 3.0, 1e-15);
    EXPECT_NEAR(integral(grid, rise, fall), 1.0 / 6.0, 1e-15);
}

TEST(WavelengthGrid, ATrapezoidInItsPlaceWouldBeFound)
{
    // On the same pieces the trapezoid gives 0.385 for the integral of x^2.
    EXPECT_GT(std::fabs((0.3 * 0.09 + 0.7 * 1.09) / 2.0 - 1.0 / 3.0), 0.05);
}

TEST(WavelengthGrid, ProductsOfGaussiansFallWithTheSixthPower)
{
    const Spectrum a = gaussian(520, 20), b = gaussian(560, 30);
    // The closed form: a Gaussian of the distance, with the variances added. What the cut at 8 deviations takes is 1e-14.
    const double variance = 20.0 * 20.0 + 30.0 * 30.0;
    const double exact =
        std::sqrt(2.0 * std::numbers::pi * 400.0 * 900.0 / variance) * std::exp(-0.5 * 40.0 * 40.0 / variance);
    std::vector<double> knots = a.knots();
    const auto more = b.knots();
    knots.insert(knots.end(), more.begin(), more.end());
    const WavelengthRange range = hullOf(a.range(), b.range());
    const auto error = [&](int cuts) {
        return std::fabs(integral(gridThrough(knots, range, cuts), a, b) / exact - 1.0);
    };
    EXPECT_LT(error(1), 1e-5);
    EXPECT_LT(error(8), 1e-10) << "three halvings gain a factor of about 2^18";
}

TEST(WavelengthGrid, WeightsAddUpToTheRangeAndKnotsBeyondItDoNotCount)
{
    const WavelengthGrid grid = gridThrough({1, 5, 5, 7, 30}, {4, 9}, 3);
    double sum = 0.0;
    for (const double weight : grid.weight)
        sum += weight;
    EXPECT_NEAR(sum, 5.0, 1e-14);
    EXPECT_GT(grid.nm.front(), 4.0);
    EXPECT_LT(grid.nm.back(), 9.0);
}

TEST(WavelengthRange, OverlapAndHull)
{
    EXPECT_TRUE(overlapOf({1, 2}, {3, 4}).empty());
    EXPECT_EQ(overlapOf({1, 3}, {2, 4}).from, 2.0);
    EXPECT_EQ(hullOf({1, 2}, {3, 4}).to, 4.0);
    EXPECT_EQ(hullOf({}, {3, 4}).from, 3.0) << "an empty range adds nothing";
}

} // namespace
} // namespace reflectance
