// Koenderink's modes as a basis: orthonormal, reciprocal, 5 and 55 of them, free to be negative.
#include "core/reflectance/lists.h"
#include "tests/models/evaluated.h"

#include <boost/math/quadrature/gauss.hpp>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Vec3d up{0, 0, 1};

const Parameter& coefficients()
{
    return *(**findModel("koenderink")).text.find("coefficients");
}

/// Coefficients of 0 but for one.
ParameterValues mode(std::size_t i, double order)
{
    std::vector<double> numbers(coefficients().formFor(order)->names.size(), 0.0);
    numbers[i] = 1.0;
    return {{"order", {order}}, {"coefficients", numbers}};
}

struct Node {
    Observation row;
    double weight, cosine;
};

/// Pairs of directions that integrate every product of two modes exactly: in x = 1 - cos(theta), which is the area on the
/// hemisphere over 2 pi, they are polynomials of degree 8 at most, in the azimuth sums of cosines up to 16 dphi.
std::vector<Node> nodes()
{
    using Rule = boost::math::quadrature::gauss<double, 10>;
    std::vector<std::pair<double, double>> inX; // x and its weight on 0 .. 1
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
        for (const double side : {-1.0, 1.0})
            inX.emplace_back(0.5 + 0.5 * side * Rule::abscissa()[i], 0.5 * Rule::weights()[i]);
    constexpr int azimuths = 18;
    std::vector<Node> all;
    for (const auto& [xL, weightL] : inX)
        for (const auto& [xV, weightV] : inX)
            for (int a = 0; a < azimuths; ++a) {
                const double phi = 2.0 * pi * a / azimuths;
                const double sinV = std::sqrt(xV * (2.0 - xV));
                const Vec3d L{std::sqrt(xL * (2.0 - xL)), 0, 1.0 - xL};
                const Vec3d V{sinV * std::cos(phi), sinV * std::sin(phi), 1.0 - xV};
                all.push_back({{up, V, {{L, Vec3d(1.0), 0.0}}}, weightL * weightV / azimuths * 4.0 * pi * pi, L.z});
            }
    return all;
}

/// Times a factor for modes with an azimuth: 1 is right.
double worstDeviation(double order, double azimuthFactor)
{
    const Model& model = **findModel("koenderink");
    const std::vector<Node> all = nodes();
    std::vector<Observation> rows;
    for (const Node& node : all)
        rows.push_back(node.row);
    const auto& names = coefficients().formFor(order)->names;
    std::vector<std::vector<double>> f;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto factors = evaluate(model, flatValues(model.text, mode(i, order)), rows, Precision::Double);
        f.emplace_back();
        for (std::size_t k = 0; k < all.size(); ++k)
            f.back().push_back(factors[k].x / (pi * all[k].cosine) * (names[i][1] == '0' ? 1.0 : azimuthFactor));
    }
    double worst = 0.0;
    for (std::size_t i = 0; i < f.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            double product = 0.0;
            for (std::size_t k = 0; k < all.size(); ++k)
                product += all[k].weight * f[i][k] * f[j][k];
            worst = std::max(worst, std::fabs(product - (i == j ? 1.0 : 0.0)));
        }
    return worst;
}

TEST(Koenderink, TheModesAreOrthonormal)
{
    // 1800 terms of up to 1 each, rounded: far below 1e-12.
    EXPECT_LE(worstDeviation(2, 1.0), 1e-12);
    EXPECT_LE(worstDeviation(8, 1.0), 1e-12);
}

/// The planted fault: the root of 2 that modes with an azimuth carry, forgotten.
TEST(Koenderink, OrthonormalityCatchesAForgottenRoot)
{
    EXPECT_GT(worstDeviation(2, 1.0 / std::sqrt(2.0)), 0.4);
}

TEST(Koenderink, HasFiveAndFiftyFiveModesInTheOrderOfTheFile)
{
    ASSERT_EQ(coefficients().forms.size(), 2U);
    for (const double order : {2.0, 8.0}) {
        std::vector<std::string> expected;
        for (int l = 0; l <= order; ++l)
            for (int n = l; n <= order; n += 2)
                for (int m = l; m <= n; m += 2)
                    expected.push_back("l" + std::to_string(l) + "_n" + std::to_string(n) + "_m" + std::to_string(m));
        EXPECT_EQ(coefficients().formFor(order)->names, expected);
        EXPECT_EQ(expected.size(), order == 2.0 ? 5U : 55U);
    }
}

TEST(Koenderink, TheFirstModeAloneIsLambert)
{
    for (const double order : {2.0, 8.0}) {
        const OracleCase c{"koenderink", mode(0, order), up, {0.6, 0, 0.8}, {0, 0.28, 0.96}};
        EXPECT_NEAR(evaluated(c, Precision::Double).x, 0.5 * 0.8, 1e-15);
    }
}

TEST(Koenderink, ABroadSurfaceIsTheSameInBothOrders)
{
    const std::vector<double> five{1.2, -0.3, 0.2, 0.4, -0.1};
    const ParameterValues fine{{"order", {8.0}},
                               {"coefficients", inForm(coefficients(), five, *coefficients().formFor(8.0))}};
    for (int i = 0; i < 50; ++i) {
        OracleCase c{"koenderink", {{"order", {2.0}}, {"coefficients", five}}, up, {}, {}};
        c.L = {std::sin(0.03 * i), 0, std::cos(0.03 * i)};
        c.V = {std::sin(0.02 * i) * std::cos(i), std::sin(0.02 * i) * std::sin(i), std::cos(0.02 * i)};
        const double coarse = evaluated(c, Precision::Double).x;
        c.parameters = fine;
        // The same products, summed with fifty zeros in between.
        EXPECT_NEAR(evaluated(c, Precision::Double).x, coarse, 1e-15);
    }
}

TEST(Koenderink, IsReciprocalModeByMode)
{
    const Vec3d L = normalized({0.9, 0.1, 0.3});
    const Vec3d V = normalized({-0.2, 0.5, 0.6});
    for (std::size_t i = 0; i < 55; ++i) {
        const OracleCase there{"koenderink", mode(i, 8), up, L, V};
        const OracleCase back{"koenderink", mode(i, 8), up, V, L};
        EXPECT_NEAR(evaluated(there, Precision::Double).x * V.z, evaluated(back, Precision::Double).x * L.z, 1e-15)
            << i;
    }
}

TEST(Koenderink, KeepsNegativeValuesAndIsDarkBelowTheHorizons)
{
    const ParameterValues forward = mode(3, 2);
    for (const Precision precision : corePrecisions) {
        const auto at = [&](const Vec3d& L, const Vec3d& V) {
            return evaluated({"koenderink", forward, up, L, V}, precision).x;
        };
        EXPECT_LT(at({0.6, 0, 0.8}, {-0.6, 0, 0.8}), -0.1);
        EXPECT_GT(at({0.6, 0, 0.8}, {0.6, 0, 0.8}), 0.1);
        EXPECT_EQ(at({0.6, 0, 0.8}, up), 0.0) << "at the pole every azimuth is the same";
        EXPECT_EQ(at({0.6, 0, -0.8}, up), 0.0);
        EXPECT_EQ(at({0.6, 0, 0.8}, {0.6, 0, -0.8}), 0.0);
        EXPECT_EQ(at({0, 0, -1}, {0, 0, -1}), 0.0) << "no NaN where 1 + cos is 0";
    }
}

} // namespace
} // namespace reflectance::test
