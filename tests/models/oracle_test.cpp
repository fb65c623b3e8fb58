// Every model in every precision of the core against 50 digits.
#include "core/math/lobe.h"
#include "tests/models/evaluated.h"
#include "tests/models/random_cases.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace reflectance::test {
namespace {

constexpr std::size_t rowsPerModel = 1000;

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

class EveryModel : public testing::TestWithParam<std::tuple<std::string, Precision>> {};

TEST_P(EveryModel, StaysWithinTheBoundOfItsArithmetic)
{
    const auto& [model, precision] = GetParam();
    double worst = 0.0;
    std::size_t bright = 0;
    for (const OracleCase& c : randomCases(model, rowsPerModel)) {
        const Vec3d got = evaluated(c, precision);
        const double ratio = ratioToBound(c, got, precision == Precision::Double);
        worst = std::max(worst, ratio);
        bright += got != Vec3d() ? 1U : 0U;
        ASSERT_LE(ratio, 1.0) << described(c);
    }
    EXPECT_GT(bright, rowsPerModel / 10) << "the rows are too dark to say anything";
    RecordProperty("worst_ratio_to_bound", std::to_string(worst));
    std::cout << model << ' ' << nameOf(precision) << ": worst ratio to the bound " << worst << '\n';
}

INSTANTIATE_TEST_SUITE_P(Oracle, EveryModel,
                         testing::Combine(testing::ValuesIn(allIds()),
                                          testing::Values(Precision::Double, Precision::Float, Precision::Simd)),
                         [](const auto& given) {
                             return std::get<0>(given.param) + "_" + std::string(nameOf(std::get<1>(given.param)));
                         });

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
