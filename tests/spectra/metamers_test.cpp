// Metamers: the same K, another colour where the light has more than three numbers.
#include "core/spectra/metamers.h"

#include "core/spectra/builtin.h"
#include "core/spectra/color_study.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

double largestDifference(const Mat3d& a, const Mat3d& b)
{
    const auto left = rowByRow(a);
    const auto right = rowByRow(b);
    double largest = 0.0;
    for (std::size_t i = 0; i < left.size(); ++i)
        largest = std::max(largest, std::fabs(left[i] - right[i]));
    return largest;
}

class Metamers : public testing::TestWithParam<const char*> {};

TEST_P(Metamers, HaveTheSameKAndDifferUnderALamp)
{
    ColorQuestion question;
    question.sensor = GetParam();
    question.primaries = "display";
    question.under = "FL11";
    const auto answer = answered(question);
    ASSERT_TRUE(answer) << answer.error().sentence();
    const Mat3d toXyz = xyzFromSensor(answer->system);
    double farthest = 0.0;
    for (const JudgedSurface& patch : answer->patches) {
        const MetamericPair pair = metamericPair(answer->system, toXyz, patch, answer->light);
        for (const double value : pair.twin)
            ASSERT_TRUE(value >= 0.0 && value <= 1.0) << patch.name;
        // Thousands of products, two passes: a thousand roundings of numbers below 1.
        EXPECT_LT(largestDifference(answer->system.M(pair.twin), patch.M), 1e-12) << patch.name;
        EXPECT_LT(pair.apartUnderWhite, 1e-6) << patch.name;
        farthest = std::max(farthest, pair.apartUnderLight);
    }
    EXPECT_GT(farthest, 1.0) << "seen by the eye: here no K can help";
}

INSTANTIATE_TEST_SUITE_P(Sensors, Metamers, testing::Values("gaussian", "nikon_d5100", "cie_1931"));

TEST(Metamers, UnderALightOfThePrimariesStayAlike)
{
    ColorQuestion question;
    question.sensor = "nikon_d5100";
    question.primaries = "display";
    question.under = "saturated blue";
    const auto answer = answered(question);
    ASSERT_TRUE(answer);
    const Mat3d toXyz = xyzFromSensor(answer->system);
    for (const JudgedSurface& patch : answer->patches)
        EXPECT_LT(metamericPair(answer->system, toXyz, patch, answer->light).apartUnderLight, 1e-6) << patch.name;
}

TEST(Metamers, AWaveThatWasNotFreedWouldBeFound)
{
    ColorQuestion question;
    const auto answer = answered(question);
    ASSERT_TRUE(answer);
    const JudgedSurface& patch = answer->patches[14];
    std::vector<double> raw = patch.S;
    for (std::size_t k = 0; k < raw.size(); ++k)
        raw[k] += 0.01 * std::cos(0.07 * (answer->system.grid.nm[k] - 550.0));
    EXPECT_GT(largestDifference(answer->system.M(raw), patch.M), 1e-5);
}

TEST(Metamers, ABlackSurfaceHasNoTwinButItself)
{
    const auto answer = answered({});
    ASSERT_TRUE(answer);
    const std::vector<double> black(answer->system.grid.size(), 0.0);
    EXPECT_EQ(metamericTwin(answer->system, black), black);
}

} // namespace
} // namespace reflectance
