// Measurements whose samples lie scattered, and those about the mirror direction: Cornell, CUReT, Zemax; and their colours.
#include "core/math/angle.h"
#include "core/measured/readers.h"
#include "core/measured/spectrum_colour.h"
#include "tests/measured/made_files.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>
#include <random>

namespace reflectance::testing {
namespace {

using ::testing::HasSubstr;
constexpr double pi = std::numbers::pi;

Vec3d anyAbove(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    return directionAt(std::acos(0.3 + 0.7 * unit(random)), 2.0 * pi * unit(random));
}

/// Samples of a function of the heights alone, as a matte surface has.
ScatteredBrdf matteSamples(std::size_t count)
{
    std::mt19937_64 random(4);
    std::vector<Vec3d> L, V;
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        L.push_back(anyAbove(random));
        V.push_back(anyAbove(random));
        values.push_back(0.2 + 0.1 * L.back().z * V.back().z);
    }
    return scatteredBrdf(L, V, values, 1);
}

TEST(Scattered, TellsASmoothSurfaceFromItsSamples)
{
    const ScatteredBrdf brdf = matteSamples(2000);
    std::mt19937_64 random(5);
    double worst = 0.0;
    std::size_t known = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3d L = anyAbove(random);
        const Vec3d V = anyAbove(random);
        const auto f = brdfAt(brdf, L, V);
        if (!f)
            continue;
        ++known;
        worst = std::max(worst, std::fabs(f->rows[0].x - 0.2 - 0.1 * L.z * V.z));
        EXPECT_EQ(f->rows[0].x, brdfAt(brdf, V, L)->rows[0].x) << "reciprocal by construction";
    }
    EXPECT_GT(known, 490U);
    // Neighbours are 0.06 away, the function's curvature is of the order of its value, 0.1: 0.1 0.06^2 and a planar fit.
    EXPECT_LT(worst, 4e-3);
}

TEST(Scattered, GivesSamplesBackAndNothingBeyondThem)
{
    const ScatteredBrdf brdf = matteSamples(300);
    std::mt19937_64 random(4);
    for (int i = 0; i < 20; ++i) {
        const Vec3d L = anyAbove(random);
        const Vec3d V = anyAbove(random);
        EXPECT_NEAR(brdfAt(brdf, L, V)->rows[0].x, 0.2 + 0.1 * L.z * V.z, 1e-6) << "a sample outweighs its neighbours";
    }
    EXPECT_FALSE(brdfAt(brdf, directionAt(1.4, 0.0), Vec3d(0, 0, 1))) << "lower than any sample";
}

TEST(Scattered, APlantedOutlierIsFoundByLeavingItOut)
{
    ScatteredBrdf brdf = matteSamples(300);
    brdf.values[17] += 1.0;
    EXPECT_GT(std::fabs((*leftOut(brdf, 17))[0] - brdf.values[17]), 0.9);
}

TEST(Cornell, AGreySpectrumIsGrey)
{
    const Measurement m = measured(cornellFile());
    EXPECT_EQ(provenanceOf(m).format, "Cornell BRDF");
    const auto f = brdfAt(m, directionAt(0.7, 1.0), directionAt(0.7, 1.0 + pi));
    for (std::size_t c = 0; c < 3; ++c) // sums of weights that make 1
        EXPECT_NEAR(dot(f->rows[c], Vec3d(1.0)), 0.25, 1e-14);
    EXPECT_EQ(channelsOf(measured(cornellFile(), {1, 500.0})), 1U);
    EXPECT_THAT(refusal(cornellFile(), {1, 700.0}), HasSubstr("from 450 to 650 nm"));
}

TEST(Cornell, TheWhiteOfTheObserverIsWhiteAndGreenIsGreen)
{
    std::vector<double> nm;
    for (int i = 0; i < 31; ++i)
        nm.push_back(400.0 + 10.0 * i);
    Vec3d white, green;
    const auto weights = colourWeights(nm);
    for (std::size_t i = 0; i < nm.size(); ++i) {
        white += weights[i];
        green += nm[i] > 520.0 && nm[i] < 560.0 ? weights[i] : Vec3d();
    }
    for (const double c : {white.x, white.y, white.z})
        EXPECT_NEAR(c, 1.0, 1e-14);
    EXPECT_GT(green.y, 0.3);
    EXPECT_LT(green.x, 0.0) << "a narrow green lies outside sRGB";
    // By hand from the table's rows at 560 nm: D65 100, xbar 0.5945, ybar 0.995, zbar 0.0039.
    const Vec3d rgb = linearFromXyz({0.5945, 0.995, 0.0039});
    EXPECT_NEAR(rgb.y, -0.9689 * 0.5945 + 1.8758 * 0.995 + 0.0415 * 0.0039, 1e-15);
}

Result<Measurement> readCurets(std::size_t surface)
{
    return readCuret(curetGeometries(), "table.txt", curetSurfaces(), {"abrdf.dat", {surface, {}}});
}

TEST(Curet, ReadsBothHalves)
{
    for (const std::size_t surface : {1U, 2U}) {
        const auto m = readCurets(surface);
        ASSERT_TRUE(m) << m.error().sentence();
        EXPECT_EQ(provenanceOf(*m).samples, 40U);
        EXPECT_EQ(provenanceOf(*m).surfaces, 2U);
        EXPECT_EQ(std::get<ScatteredBrdf>(*m).directions.size(), 40U);
        EXPECT_NEAR(brdfAt(*m, directionAt(0.4, 0.0), directionAt(0.5, 2.5))->rows[0].x,
                    0.1 * static_cast<double>(surface), 1e-15);
    }
    EXPECT_THAT(readCurets(3).error().sentence(), HasSubstr("holds 2 surfaces; there is no number 3"));
    EXPECT_THAT(refusal(curetSurfaces()), HasSubstr("one half of a CUReT"));
}

TEST(Zemax, CountsAnglesFromTheMirrorDirection)
{
    const Table t = table(zemaxFile());
    EXPECT_EQ(t.system, AngleSystem::Specular);
    const auto f = [&](double thetaI, double thetaR, double phi) {
        return brdfAt(t, directionAt(radians(thetaI), 0.0), directionAt(radians(thetaR), phi));
    };
    EXPECT_NEAR(f(10, 10, pi)->rows[0].x, 0.11, 1e-15);
    EXPECT_NEAR(f(40, 55, pi)->rows[1].y, 0.14, 1e-15) << "15 degrees beyond the mirror direction";
    EXPECT_NEAR(f(25, 25, pi)->rows[0].x, 0.125, 1e-15) << "between two angles of incidence";
    EXPECT_FALSE(f(50, 50, pi)) << "more than was measured";
    EXPECT_FALSE(f(10, 50, 0.0)) << "0 stands for not measured: 60 degrees from the mirror direction";
    // Four azimuth-and-radial rows of zeros; at 40 degrees those of azimuth 180 look below the surface.
    EXPECT_THAT(t.provenance.warnings.at(0), HasSubstr("exactly 0"));
}

} // namespace
} // namespace reflectance::testing
