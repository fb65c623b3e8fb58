// The spectra that the program carries, against what is published of them.
#include "core/image/colour_difference.h"
#include "core/spectra/builtin.h"
#include "core/spectra/color_system.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace reflectance {
namespace {

/// X, Y, Z of a light on a surface, summed each 5 nm, as the published figures of these lights are.
Vec3d xyzByCie(const Spectrum& light, const Spectrum* surface = nullptr)
{
    Vec3d sum;
    for (int nm = 380; nm <= 780; nm += 5) {
        const double power = light.at(nm) * (surface ? surface->at(nm) : 1.0);
        const SpectrumTriple& o = standardObserver();
        sum += power * Vec3d(o[0].at(nm), o[1].at(nm), o[2].at(nm));
    }
    return sum;
}

TEST(Builtin, TheObserverIsTheStandardOne)
{
    const Spectrum& y = standardObserver()[1];
    // The sum of y over 360 .. 830 nm, and its peak, as the standard prints them.
    EXPECT_NEAR(std::accumulate(y.values.begin(), y.values.end(), 0.0), 106.857, 5e-4);
    EXPECT_EQ(y.at(555), 1.0);
    EXPECT_EQ(y.nm.size(), 471U);
}

TEST(Builtin, LightsHaveTheirPublishedChromaticities)
{
    struct Row {
        const char* name;
        double x, y;
    };
    // CIE 15:2004, table T.3, and the fluorescent lamps' table.
    const Row rows[] = {{"A", 0.44758, 0.40745}, {"D50", 0.34567, 0.35851}, {"D65", 0.31272, 0.32903},
                        {"FL2", 0.3721, 0.3751}, {"FL11", 0.3805, 0.3769},  {"E", 1.0 / 3.0, 1.0 / 3.0}};
    for (const Row& row : rows) {
        const Vec3d XYZ = xyzByCie(*lightNamed(row.name));
        const double sum = XYZ.x + XYZ.y + XYZ.z;
        // The lamps' figures have four digits, the others five; each may lie half a unit away, and E's sum is not exact.
        EXPECT_NEAR(XYZ.x / sum, row.x, 6e-5) << row.name;
        EXPECT_NEAR(XYZ.y / sum, row.y, 6e-5) << row.name;
    }
}

TEST(Builtin, AIsPlancksLawAt2848Kelvin)
{
    // CIE 15:2004: 100 (560/nm)^5 (exp(1.435e7 / (2848 560)) - 1) / (exp(1.435e7 / (2848 nm)) - 1).
    const Spectrum A = *lightNamed("A");
    for (const double nm : A.nm) {
        const double power =
            100.0 * std::pow(560.0 / nm, 5) * std::expm1(1.435e7 / (2848 * 560)) / std::expm1(1.435e7 / (2848 * nm));
        EXPECT_NEAR(A.at(nm) / power, 1.0, 1e-5) << "six digits are printed, at " << nm;
    }
}

TEST(Builtin, TheChartIsTheManufacturersChart)
{
    ASSERT_EQ(colorChecker().size(), 24U);
    struct Row {
        std::size_t patch;
        const char* name;
        Lab lab;
    };
    // The manufacturer's Lab under D50 for charts since 2014. Thirty earlier charts differ from that by up to 3 units.
    const Row rows[] = {{0, "dark skin", {37.54, 14.37, 14.92}}, {6, "orange", {62.73, 35.83, 56.5}},
                        {12, "blue", {28.37, 15.42, -49.8}},     {13, "green", {54.38, -39.72, 32.27}},
                        {14, "red", {42.43, 51.05, 28.62}},      {17, "cyan", {49.57, -29.71, -28.32}},
                        {19, "neutral 8", {81.29, -0.57, 0.44}}, {23, "black 2", {20.64, 0.07, -0.46}}};
    const Spectrum D50 = *lightNamed("D50");
    const Vec3d white = xyzByCie(D50);
    for (const Row& row : rows) {
        const Spectrum& patch = colorChecker()[row.patch];
        EXPECT_EQ(patch.name, row.name);
        const Lab lab = labOf(xyzByCie(D50, &patch), white);
        EXPECT_LT(std::hypot(lab.L - row.lab.L, lab.a - row.lab.a, lab.b - row.lab.b), 3.0) << row.name;
    }
    // The planted fault: another patch is far away.
    const Lab red = labOf(xyzByCie(D50, &colorChecker()[14]), white);
    EXPECT_GT(std::hypot(red.L - 49.57, red.a + 29.71, red.b + 28.32), 50.0);
}

TEST(Builtin, LinearSrgbSeesD65AsWhite)
{
    AlsoOnGrid also;
    also.lights = {*lightNamed("D65")};
    const auto system = makeColorSystem(*primariesNamed("leds"), *sensorNamed("srgb"), also);
    ASSERT_TRUE(system);
    const Vec3d seen = system->response(sampledOn(system->grid, also.lights[0]), {});
    // The standard's matrix has four digits, and rounds the white's chromaticity to as many.
    EXPECT_NEAR(seen.x / seen.y, 1.0, 2e-3);
    EXPECT_NEAR(seen.z / seen.y, 1.0, 2e-3);
}

TEST(Builtin, EveryNameOfTheListIsUnderstoodAndHasItsSource)
{
    EXPECT_GT(builtinSpectra().size(), 15U);
    for (const BuiltinSpectra& builtin : builtinSpectra()) {
        EXPECT_FALSE(builtin.source.empty()) << builtin.name;
        const std::size_t colon = builtin.name.find(':');
        std::string name(builtin.name.substr(0, colon));
        if (colon != std::string_view::npos)
            name += ":0.5";
        const bool understood = builtin.role == SpectrumRole::Reflectance ? reflectancesNamed(name).has_value()
                                : builtin.role == SpectrumRole::Sensor    ? sensorNamed(name).has_value()
                                                                          : primariesNamed(name).has_value();
        EXPECT_TRUE(understood) << name;
    }
}

} // namespace
} // namespace reflectance
