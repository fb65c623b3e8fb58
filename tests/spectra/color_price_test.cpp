// What each cheat costs: nothing where theory says nothing, and what it must cost elsewhere.
#include "core/spectra/builtin.h"
#include "core/spectra/color_price.h"
#include "core/spectra/color_study.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

struct Bench {
    ColorSystem system;
    std::vector<JudgedSurface> surfaces;
    std::vector<JudgedLight> lights;

    [[nodiscard]] CheatPrice price(Cheat cheat, const std::vector<JudgedLight>& under) const
    {
        return pricesOfCheats(system, surfaces, under)[static_cast<std::size_t>(cheat)];
    }
};

Bench benchOf(const std::string& sensor, const std::vector<std::string>& outside = {})
{
    AlsoOnGrid also;
    also.reflectances = colorChecker();
    for (const std::string& name : outside)
        also.lights.push_back(*lightNamed(name));
    auto system = makeColorSystem(*primariesNamed("display"), *sensorNamed(sensor), also);
    EXPECT_TRUE(system);
    Bench bench{*std::move(system), {}, {}};
    for (const Spectrum& patch : also.reflectances)
        bench.surfaces.push_back(judgedSurface(bench.system, patch));
    for (const Spectrum& light : also.lights)
        bench.lights.push_back(judgedLight(bench.system, light));
    return bench;
}

TEST(ColorPrice, TheFullKCostsNothingForLightsOfThePrimaries)
{
    const Bench bench = benchOf("nikon_d5100");
    const CheatPrice full = bench.price(Cheat::FullK, lightsInSpan(bench.system));
    EXPECT_EQ(full.each.size(), 24U * 9U);
    EXPECT_LT(full.maxLinear, 1e-13);
    // dE2000 of two colours 1e-13 apart, whose Lab has slopes up to 1e3 times 1/white.
    EXPECT_LT(full.max, 1e-8);
}

TEST(ColorPrice, TheColourUnderWhiteIsExactUnderWhiteAloneAndTheOthersAreNot)
{
    const Bench bench = benchOf("nikon_d5100");
    const std::vector<JudgedLight> all = lightsInSpan(bench.system);
    const std::vector<JudgedLight> white{all.front()};
    EXPECT_EQ(white[0].name, "white");
    EXPECT_LT(bench.price(Cheat::ColorUnderWhite, white).maxLinear, 1e-13);
    EXPECT_GT(bench.price(Cheat::DiagonalOfM, white).mean, 1.0);
    EXPECT_GT(bench.price(Cheat::DroppedOffDiagonals, white).mean, 1.0);
    EXPECT_GT(bench.price(Cheat::ColorUnderWhite, all).mean, 1.0);
}

TEST(ColorPrice, NarrowFiltersMakeTheCheatCheap)
{
    const auto meanOf = [](const char* sensor, Cheat cheat) {
        const Bench bench = benchOf(sensor);
        return bench.price(cheat, lightsInSpan(bench.system)).mean;
    };
    EXPECT_LT(meanOf("narrow", Cheat::DroppedOffDiagonals), 0.5);
    EXPECT_LT(meanOf("narrow", Cheat::ColorUnderWhite), 0.5);
    EXPECT_GT(meanOf("nikon_d5100", Cheat::DroppedOffDiagonals), 3.0);
    EXPECT_GT(meanOf("nikon_d5100", Cheat::ColorUnderWhite), 1.0);
}

TEST(ColorPrice, TheBestDiagonalIsNoWorseThanTheOthersInLeastSquares)
{
    const Bench bench = benchOf("nikon_d5100");
    const std::vector<JudgedLight> lights = lightsInSpan(bench.system);
    for (const JudgedSurface& surface : bench.surfaces) {
        const auto squares = [&](Cheat cheat) {
            double sum = 0.0;
            for (const JudgedLight& light : lights) {
                const Vec3d off = matrixBy(cheat, bench.system, surface) * light.seen - surface.K * light.seen;
                sum += dot(off, off);
            }
            return sum;
        };
        const double best = squares(Cheat::BestDiagonal);
        EXPECT_LE(best, squares(Cheat::DroppedOffDiagonals)) << surface.name;
        EXPECT_LE(best, squares(Cheat::ColorUnderWhite)) << surface.name;
    }
}

TEST(ColorPrice, NoKHelpsUnderALightOfAnotherShape)
{
    const Bench bench = benchOf("nikon_d5100", {"FL11", "D65"});
    for (const JudgedLight& light : bench.lights) {
        EXPECT_FALSE(light.inSpan);
        EXPECT_GT(bench.price(Cheat::FullK, {light}).mean, 0.3) << light.name;
    }
}

TEST(ColorPrice, ThePriceAgreesWithOnesOwnReckoning)
{
    // One patch under one light, through every step by hand from the matrices alone.
    const Bench bench = benchOf("cie_1931");
    const JudgedLight blue = lightsInSpan(bench.system).back();
    EXPECT_EQ(blue.name, "pure blue");
    const CheatPrice dropped = bench.price(Cheat::DroppedOffDiagonals, {blue});
    for (std::size_t s = 0; s < bench.surfaces.size(); ++s) {
        const Mat3d& K = bench.surfaces[s].K;
        const Vec3d off = K * blue.seen - Vec3d(K.rows[0].x, K.rows[1].y, K.rows[2].z) * blue.seen;
        const double largest = std::max({std::fabs(off.x), std::fabs(off.y), std::fabs(off.z)});
        EXPECT_LE(largest / std::max({blue.white.x, blue.white.y, blue.white.z}), dropped.maxLinear * (1 + 1e-12));
        EXPECT_GE(dropped.max, dropped.each[s]);
    }
    EXPECT_EQ(dropped.each[dropped.worstSurface], dropped.max);
}

TEST(ColorPrice, XyzOfTheObserverIsItself)
{
    const Bench bench = benchOf("cie_1931");
    const Mat3d C = xyzFromSensor(bench.system);
    // The fit has an exact answer, the identity; normal equations lose the square of the colours' condition (about 1e2).
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Vec3d row = C.rows[i];
            EXPECT_NEAR(j == 0 ? row.x : j == 1 ? row.y : row.z, i == j ? 1.0 : 0.0, 1e-10);
        }
}

TEST(ColorStudy, AnswersForEveryLightAndShowsTheTruth)
{
    for (const char* under : {"white", "pure blue", "FL11"}) {
        ColorQuestion question;
        question.sensor = "nikon_d5100";
        question.primaries = "display";
        question.under = under;
        const auto answer = answered(question);
        ASSERT_TRUE(answer) << under;
        EXPECT_EQ(answer->prices.size(), std::size(allCheats));
        EXPECT_EQ(answer->truth.size(), 24U);
        EXPECT_EQ(answer->byCheat[4].size(), 24U);
    }
    ColorQuestion wrong;
    wrong.under = "moonlight";
    EXPECT_FALSE(answered(wrong));
}

TEST(ColorStudy, WhiteIsShownWhite)
{
    const Bench bench = benchOf("nikon_d5100");
    const Mat3d toXyz = xyzFromSensor(bench.system);
    const Vec3d seen{0.7, 0.9, 0.4};
    // A response equal to the light's own is the white of the display: 1, 1, 1 up to rounding.
    EXPECT_LT(length(displayed(toXyz, seen, seen) - Vec3d(1.0)), 1e-13);
    EXPECT_LT(length(displayed(toXyz, 0.5 * seen, seen) - Vec3d(0.5)), 1e-13);
}

} // namespace
} // namespace reflectance
