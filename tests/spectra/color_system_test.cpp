// K from spectra against closed forms and an independent quadrature; its two conventions; what cannot be derived.
#include "core/spectra/builtin.h"
#include "core/spectra/color_system.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace reflectance {
namespace {

Spectrum gaussian(double center, double deviation, double height = 1.0)
{
    Spectrum spectrum;
    spectrum.name = "gaussian";
    spectrum.bands = {{center, deviation, height}};
    return spectrum;
}

Spectrum table(std::vector<double> nm, std::vector<double> values, Outside outside = Outside::Zero)
{
    Spectrum spectrum;
    spectrum.name = "table";
    spectrum.nm = std::move(nm);
    spectrum.values = std::move(values);
    spectrum.outside = outside;
    return spectrum;
}

ColorSystem systemOf(const std::string& light, const std::string& sensor, AlsoOnGrid also = {})
{
    auto system = makeColorSystem(*primariesNamed(light), *sensorNamed(sensor), also);
    EXPECT_TRUE(system) << light << ", " << sensor;
    return *std::move(system);
}

double largestDifference(const Mat3d& a, const Mat3d& b)
{
    const auto x = rowByRow(a);
    const auto y = rowByRow(b);
    double largest = 0.0;
    for (std::size_t i = 0; i < 9; ++i)
        largest = std::max(largest, std::fabs(x[i] - y[i]));
    return largest;
}

/// Boole's rule in long double on equal steps through every sample: another rule, other nodes, other precision.
long double byBoole(const Spectrum& S, const Spectrum& P, const Spectrum& s, double from, double to, int pieces)
{
    const long double h = (static_cast<long double>(to) - from) / pieces / 4;
    const auto f = [&](int k) {
        const auto nm = static_cast<double>(from + k * h);
        return static_cast<long double>(S.at(nm)) * P.at(nm) * s.at(nm);
    };
    long double sum = 0;
    for (int i = 0; i < pieces; ++i)
        sum += 7 * f(4 * i) + 32 * f(4 * i + 1) + 12 * f(4 * i + 2) + 32 * f(4 * i + 3) + 7 * f(4 * i + 4);
    return sum * 2 * h / 45;
}

TEST(ColorSystem, AgreesWithAnIndependentQuadrature)
{
    // Samples at whole nm, so that pieces of 1 nm are cubics, which Boole's rule integrates exactly. FL11 jumps from
    // 5 nm to 5 nm by a factor of 30: hard for any rule that steps over its samples.
    const SpectrumTriple P = *primariesNamed("FL11");
    const SpectrumTriple s = *sensorNamed("nikon_d5100");
    const Spectrum patch = colorChecker()[14];
    AlsoOnGrid also;
    also.reflectances = {patch};
    const auto system = makeColorSystem(P, s, also);
    ASSERT_TRUE(system);
    ASSERT_TRUE(system->makesWhite);
    const Mat3d M = system->M(sampledOn(system->grid, patch));
    const double gains[] = {system->gain.x, system->gain.y, system->gain.z};
    const auto entries = rowByRow(M);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            // The bands pass over within half a nm: pieces of half a nm.
            const auto exact = static_cast<double>(byBoole(patch, P[j], s[i], 380, 780, 800)) * gains[j];
            // 1e-12 of the largest entry, which is about 1: sums of 1000 terms round to 1e-14.
            EXPECT_NEAR(entries[3 * i + j], exact, 1e-12) << i << j;
        }
    EXPECT_LE(system->lastChange, 1e-12);
}

TEST(ColorSystem, AgreesWithTheClosedFormOfGaussians)
{
    // Three Gaussians: their exponents add up to one quadratic.
    const double c[] = {530, 550, 545}, d[] = {30, 20, 25};
    double A = 0, B = 0, C = 0;
    for (int k = 0; k < 3; ++k) {
        A += 1 / (d[k] * d[k]);
        B += c[k] / (d[k] * d[k]);
        C += c[k] * c[k] / (d[k] * d[k]);
    }
    const double exact = std::sqrt(2 * std::numbers::pi / A) * std::exp(-0.5 * (C - B * B / A));
    const SpectrumTriple P{gaussian(620, 20), gaussian(c[0], d[0]), gaussian(450, 20)};
    const SpectrumTriple s{gaussian(610, 20), gaussian(c[1], d[1]), gaussian(460, 20)};
    Spectrum S = gaussian(c[2], d[2]);
    AlsoOnGrid also;
    also.reflectances = {S};
    const auto system = makeColorSystem(P, s, also);
    ASSERT_TRUE(system);
    const Mat3d M = system->M(sampledOn(system->grid, S));
    // 1e-12 is what the grid promises; the closed form's C - B^2/A loses 3 digits of its 16.
    EXPECT_NEAR(M.rows[1].y / system->gain.y / exact, 1.0, 1e-11);
}

TEST(ColorSystem, KIsExactForEveryLightOfThePrimaries)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> strength(0.0, 2.0);
    AlsoOnGrid also;
    also.reflectances = colorChecker();
    for (const char* sensor : {"nikon_d5100", "cie_1931", "gaussian:0.5", "narrow"}) {
        const ColorSystem system = systemOf("display", sensor, also);
        for (const Spectrum& patch : colorChecker()) {
            const auto S = sampledOn(system.grid, patch);
            const Vec3d I{strength(random), strength(random), strength(random)};
            std::vector<double> light(system.grid.size());
            for (std::size_t k = 0; k < light.size(); ++k)
                light[k] = I.x * system.primaries[0][k] + I.y * system.primaries[1][k] + I.z * system.primaries[2][k];
            const Vec3d truth = system.response(light, S);
            const Vec3d byM = system.K(S, Convention::Primary) * I;
            const Vec3d byK = system.K(S, Convention::Sensor) * system.response(light, {});
            const double size = length(truth);
            EXPECT_LT(length(byM - truth), 1e-12 * size) << sensor << ", " << patch.name;
            EXPECT_LT(length(byK - truth), 1e-12 * size) << sensor << ", " << patch.name;
            // The planted fault: one convention's matrix with the other's light.
            EXPECT_GT(length(system.K(S, Convention::Primary) * system.response(light, {}) - truth), 1e-5 * size);
        }
    }
}

TEST(ColorSystem, GreyIsKdTimesIdentityInTheSensorConventionAndKdTimesWInTheOther)
{
    for (const char* sensor : {"nikon_d5100", "sigma_sd_merrill", "srgb", "gaussian:0.9"}) {
        const ColorSystem system = systemOf("leds", sensor);
        const std::vector<double> grey(system.grid.size(), 0.4);
        // Rounding of W's inverse, as much as its condition allows.
        EXPECT_LT(largestDifference(system.K(grey, Convention::Sensor), diagonalMatrix(Vec3d(0.4))),
                  4e-15 * system.condition)
            << sensor;
        const Mat3d M = system.K(grey, Convention::Primary);
        const Mat3d kdW = diagonalMatrix(Vec3d(0.4)) * system.W;
        EXPECT_LT(largestDifference(M, kdW), 1e-14 * singularValues(kdW).x) << sensor;
        EXPECT_GT(std::fabs(M.rows[1].x), 1e-3) << "off-diagonals, though the surface is grey";
    }
}

TEST(ColorSystem, WhiteIsOneInEveryChannel)
{
    for (const char* sensor : {"nikon_d5100", "cie_1931", "gaussian:0.2"}) {
        const ColorSystem system = systemOf("display", sensor);
        EXPECT_TRUE(system.makesWhite);
        EXPECT_LT(length(system.W * Vec3d(1.0) - Vec3d(1.0)), 1e-13) << sensor;
    }
}

TEST(ColorSystem, OffDiagonalsGrowFromZeroWithTheOverlapOfTheFilters)
{
    double before = -1.0;
    for (const double crossing : {0.0, 0.001, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95}) {
        // Balanced, so that white stays (1,1,1) while the filters widen.
        const auto filters = balanced(gaussianSensor(crossing), *lightNamed("E"));
        ASSERT_TRUE(filters) << crossing;
        const auto system = makeColorSystem(*primariesNamed("E"), *filters, {});
        ASSERT_TRUE(system) << crossing;
        const Mat3d M = system->M(std::vector<double>(system->grid.size(), 0.5));
        double off = 0.0;
        double all = 0.0;
        const auto entries = rowByRow(M);
        for (std::size_t i = 0; i < 9; ++i) {
            all += entries[i];
            off += i % 4 == 0 ? 0.0 : entries[i];
        }
        EXPECT_GT(off / all, before) << crossing;
        before = off / all;
        if (crossing == 0.0) {
            EXPECT_EQ(off, 0.0) << "filters of 1 nm see one band of the light each";
            before = 0.0;
        }
    }
    EXPECT_GT(before, 0.3);
}

TEST(ColorSystem, FiltersCrossAtTheHeightNamed)
{
    for (const double crossing : {0.05, 0.5, 0.95}) {
        const SpectrumTriple s = gaussianSensor(crossing);
        EXPECT_NEAR(s[0].at(580), crossing, 1e-14);
        EXPECT_NEAR(s[1].at(580), crossing, 1e-14);
        EXPECT_NEAR(s[2].at(500), crossing, 1e-14);
    }
}

TEST(ColorSystem, PrimariesThatCannotMakeTheWhiteAreFoundAndLeftAsGiven)
{
    // A green filter so sensitive that red and blue alone are greener than white.
    SpectrumTriple s = *sensorNamed("nikon_d5100");
    s[1] = scaled(s[1], 10.0);
    const auto system = makeColorSystem(*primariesNamed("display"), s, {});
    ASSERT_TRUE(system);
    EXPECT_FALSE(system->makesWhite);
    EXPECT_LT(std::min({system->gain.x, system->gain.y, system->gain.z}), 0.0);
    // Balanced, the same sensor has a white.
    const auto good = makeColorSystem(*primariesNamed("display"), *balanced(s, *lightNamed("E")), {});
    ASSERT_TRUE(good);
    EXPECT_TRUE(good->makesWhite);
}

TEST(ColorSystem, BalancedFiltersSeeTheLightAsOne)
{
    const Spectrum D65 = *lightNamed("D65");
    AlsoOnGrid also;
    also.lights = {D65};
    const auto system = makeColorSystem(*primariesNamed("display"), *balanced(*sensorNamed("nikon_d5100"), D65), also);
    ASSERT_TRUE(system);
    const Vec3d seen = system->response(sampledOn(system->grid, D65), {});
    EXPECT_LT(length(seen - Vec3d(1.0)), 1e-13);
}

void expectRefused(const SpectrumTriple& P, const SpectrumTriple& s, const AlsoOnGrid& also, const char* says)
{
    const auto system = makeColorSystem(P, s, also);
    ASSERT_FALSE(system) << says;
    EXPECT_NE(system.error().message.find(says), std::string::npos) << system.error().message;
}

TEST(ColorSystem, WhatCannotBeDerivedIsOneSentence)
{
    const SpectrumTriple P = *primariesNamed("display");
    const SpectrumTriple s = *sensorNamed("nikon_d5100");
    const Spectrum infrared = table({900, 1000}, {1, 1});
    const Spectrum none = table({400, 700}, {0, 0});
    expectRefused(P, {infrared, infrared, infrared}, {}, "no wavelength in common");
    AlsoOnGrid also;
    also.reflectances = {infrared};
    expectRefused(P, s, also, "reflectance 'table'");
    expectRefused(P, {s[0], none, s[2]}, {}, "green filter 'table' sees nothing");
    expectRefused(P, {s[0], s[0], s[2]}, {}, "singular");
    expectRefused({P[0], P[1], P[1]}, s, {}, "singular");
    EXPECT_FALSE(balanced(s, infrared));
}

TEST(Matrix3, InverseProductAndSingularValues)
{
    const Mat3d m{{{4, -2, 1}, {0.5, 3, -1}, {2, 0, 5}}};
    const Mat3d one = diagonalMatrix(Vec3d(1.0));
    // Three products each, with a condition of 4.
    EXPECT_LT(largestDifference(m * inverse(m), one), 2e-15);
    EXPECT_LT(largestDifference(inverse(m) * m, one), 2e-15);
    const Vec3d s = singularValues(diagonalMatrix({-3, 1e-9, 7}));
    EXPECT_EQ(s.x, 7.0);
    EXPECT_EQ(s.y, 3.0);
    EXPECT_EQ(s.z, 1e-9);
    // |det| is their product, the Frobenius norm their length: 2 of 3 invariants; here det = 4*15+2*4.5+1*(-6) = 63.
    const Vec3d t = singularValues(m);
    EXPECT_NEAR(t.x * t.y * t.z, 63.0, 1e-12);
    EXPECT_NEAR(length(t), std::sqrt(16 + 4 + 1 + 0.25 + 9 + 1 + 4 + 25), 1e-14);
    EXPECT_TRUE(conditionNumber({{{1, 2, 3}, {2, 4, 6}, {0, 1, 0}}}) > 1e15);
}

} // namespace
} // namespace reflectance
