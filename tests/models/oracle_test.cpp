// Every model in every precision of the core against 50 digits.
#include "core/math/lobe.h"
#include "tests/models/evaluated.h"
#include "tests/models/random_cases.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace reflectance::test {
namespace {

std::string described(const OracleCase& c)
{
    std::ostringstream text;
    text.precision(17);
    const auto vector = [&](const char* name, const Vec3d& v) {
        text << name << " = " << v.x << ' ' << v.y << ' ' << v.z << "; ";
    };
    vector("N", c.N);
    vector("L", c.L);
    vector("V", c.V);
    vector("I", c.I);
    text << "radius = " << c.radius;
    for (const auto& [name, numbers] : c.parameters)
        for (const double number : numbers)
            text << "; " << name << " = " << number;
    return text.str();
}

/// Worst ratio to the bound over the rows in each of these precisions, which share one roundoff, and one answer a row.
void holdToTheBound(const std::string& model, const std::vector<Precision>& precisions)
{
    const bool isDouble = precisions.front() == Precision::Double;
    const std::size_t rows = rowsPerModel(1000);
    std::vector<double> worst(precisions.size(), 0.0);
    const double eps = isDouble ? 0x1p-53 : 0x1p-24;
    std::size_t bright = 0;
    std::size_t withoutHalfVector = 0;
    for (const OracleCase& c : randomCases(model, rows)) {
        withoutHalfVector += hasNoHalfVector(c, eps) ? 1U : 0U;
        for (std::size_t i = 0; i < precisions.size(); ++i) {
            const double before = worst[i];
            const Vec3d got = evaluated(c, precisions[i]);
            worst[i] = worstRatio(before, c, got, isDouble);
            bright += i == 0 && got != Vec3d() ? 1U : 0U;
            EXPECT_TRUE(worst[i] <= 1.0 || worst[i] == before) << nameOf(precisions[i]) << ": " << described(c);
        }
    }
    EXPECT_GT(bright, rows / 10) << "the rows are too dark to say anything";
    EXPECT_LE(withoutHalfVector, isDouble ? 0 : rows / 50) << "too many rows that say nothing";
    for (std::size_t i = 0; i < precisions.size(); ++i) {
        EXPECT_LE(worst[i], 1.0);
        std::cout << model << ' ' << nameOf(precisions[i]) << ": worst ratio to the bound " << worst[i] << " in "
                  << rows << " rows\n";
    }
}

class EveryModel : public testing::TestWithParam<std::string> {};

TEST_P(EveryModel, StaysWithinTheBoundInDouble)
{
    holdToTheBound(GetParam(), {Precision::Double});
}

TEST_P(EveryModel, StaysWithinTheBoundInFloatAndLanes)
{
    holdToTheBound(GetParam(), {Precision::Float, Precision::Simd});
}

INSTANTIATE_TEST_SUITE_P(Oracle, EveryModel, testing::ValuesIn(allIds()),
                         [](const auto& given) { return given.param; });

TEST(Oracle, CoversTheWholeCatalogue)
{
    for (const Model& model : catalogue())
        EXPECT_NO_THROW((void)oracle(randomCases(model.id(), 1).front(), 0x1p-53)) << model.id();
}

TEST(Oracle, GivesThePublishedPowersOfCosines)
{
    struct Figure {
        double angle, n, value;
    };
    for (const auto& [angle, n, value] :
         {Figure{1e-3, 1e6, 0.6065306091684}, Figure{1e-4, 1e7, 0.951229424421}, Figure{1e-3, 1e7, 0.00673794138413}}) {
        const OracleCase c{
            "phong", {{"ks", {1.0}}, {"n", {n}}}, {0, 0, 1}, {0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}};
        // The figures are printed to 12 or 13 digits.
        EXPECT_NEAR(oracle(c, 0x1p-53).value.x / value, 1.0, 1e-11);
        EXPECT_NEAR(evaluated(c, Precision::Double).x / value, 1.0, 1e-11);
    }
}

/// The planted fault: the power of the plain dot product, which every textbook writes.
TEST(Oracle, RefusesThePowerOfTheDotProductAtLargeExponents)
{
    double worstFloat = 0.0;
    double worstDouble = 0.0;
    for (OracleCase c : randomCases("phong", 200)) {
        c.parameters["n"] = {1e6};
        const Vec3d N = normalized(c.N);
        const Vec3d L = normalized(c.L);
        const Vec3d V = normalized(c.V);
        const double ks = c.parameters["ks"][0];
        const auto naive = [&](auto zero) {
            using T = decltype(zero);
            const Vec3<T> R = mirrored(Vec3<T>(N), Vec3<T>(L));
            const T cosine = reflectance::dot(R, Vec3<T>(V));
            const bool shines = reflectance::dot(Vec3<T>(N), Vec3<T>(L)) > 0 && cosine > 0;
            return (shines ? double(std::pow(cosine, T(1e6))) * ks : 0.0) * c.I;
        };
        worstFloat = std::max(worstFloat, ratioToBound(c, naive(0.0F), false));
        worstDouble = std::max(worstDouble, ratioToBound(c, naive(0.0), true));
    }
    EXPECT_GT(worstFloat, 10.0);
    EXPECT_GT(worstDouble, 10.0);
}

} // namespace
} // namespace reflectance::test
