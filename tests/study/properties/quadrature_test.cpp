// The quadrature under `check`, against integrals that are known in closed form or published.
#include "core/math/angle.h"
#include "core/study/properties/albedo.h"

#include <gtest/gtest.h>
#include <numbers>

namespace reflectance::test {
namespace {

using properties::HemisphereSums;
using properties::Share;

constexpr double pi = std::numbers::pi;
constexpr double angles[] = {0, 1e-3, 30, 45, 60, 80, 89, 89.99};
/// What issue and interface promise of every share.
constexpr double promised = 1e-6;

Share albedo(const char* model, const ParameterValues& values, double angle)
{
    const Model& found = **findModel(model);
    return HemisphereSums(angle).albedo(found, flatValues(found.text, values));
}

Share furnace(const char* model, const ParameterValues& values, double angle)
{
    const Model& found = **findModel(model);
    return HemisphereSums(angle).furnace(found, flatValues(found.text, values));
}

TEST(GaussLegendre, IsExactForPolynomials)
{
    for (const int order : {1, 2, 3, 12, 18, 36, 72}) {
        const auto rule = properties::gaussLegendre(order);
        for (const int degree : {0, 1, 2 * order - 1}) {
            double sum = 0.0;
            for (std::size_t i = 0; i < rule.x.size(); ++i)
                sum += rule.weight[i] * std::pow(rule.x[i], degree);
            // order roundings of the sum, and pow's own of `degree` steps
            EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-14) << order << ", degree " << degree;
        }
        double beyond = 0.0;
        for (std::size_t i = 0; i < rule.x.size(); ++i)
            beyond += rule.weight[i] * std::pow(rule.x[i], 2 * order);
        if (order <= 3) {
            EXPECT_GT(std::fabs(beyond - 1.0 / (2 * order + 1)), 1e-5) << "and not for the next degree";
        }
    }
}

TEST(Hemisphere, HasItsAreaAndItsShadow)
{
    for (const double angle : angles) {
        double area = 0.0;
        double shadow = 0.0;
        for (const auto& d : properties::hemisphere({radians(angle), 0.05}, 18)) {
            ASSERT_GE(d.direction.z, -1e-15);
            area += d.weight;
            shadow += d.weight * d.direction.z;
        }
        EXPECT_NEAR(area / (2.0 * pi), 1.0, promised) << angle;
        EXPECT_NEAR(shadow / pi, 1.0, promised) << angle;
    }
}

TEST(Albedo, OfLambertIsKd)
{
    for (const double angle : angles) {
        EXPECT_NEAR(albedo("lambert", {{"kd", {0.37}}}, angle).value.x, 0.37, promised) << angle;
        EXPECT_NEAR(furnace("lambert", {{"kd", {0.37}}}, angle).value.x, 0.37, promised) << angle;
    }
}

TEST(Albedo, OfAColourMatrixIsItsRowSums)
{
    const ParameterValues K{{"K", {0.5, 0.25, 0.125, 0, 0, 1.5, -0.25, 0, 0}}};
    const Vec3d share = albedo("lambert_color", K, 60).value;
    EXPECT_NEAR(share.x, 0.875, promised);
    EXPECT_NEAR(share.y, 1.5, promised) << "hazard H24: computed as it is";
    EXPECT_NEAR(share.z, -0.25, promised) << "hazard H21: the sign stays";
}

TEST(Albedo, OfAMirrorIsItsReflectance)
{
    for (const double angle : angles) {
        EXPECT_NEAR(albedo("mirror", {{"reflectance", {0.6}}}, angle).value.x, 0.6, promised) << angle;
        EXPECT_NEAR(furnace("mirror", {{"reflectance", {0.6}}}, angle).value.x, 0.6, promised) << angle;
    }
}

/// Lobe integrals: 2 pi / (n+1), and 2 pi / (n+2) with the cosine, where the lobe stands upright.
TEST(Albedo, OfAnUprightHighlightIsClosedForm)
{
    for (const double n : {0.0, 0.5, 1.0, 7.0, 40.0, 1e3, 1e5, 1e7}) {
        const ParameterValues values{{"ks", {1}}, {"n", {n}}};
        EXPECT_NEAR(albedo("phong", values, 0).value.x * (n + 2) / 2, 1.0, promised) << n;
        EXPECT_NEAR(furnace("phong", values, 0).value.x * (n + 1) / 2, 1.0, promised) << n;
    }
}

/// The view factor of a tilted hemisphere, (1 + cos a) / 2: a leaning highlight of n = 1, cut by the horizon.
TEST(Albedo, OfALeaningBroadHighlightIsTheViewFactor)
{
    for (const double angle : angles)
        EXPECT_NEAR(furnace("phong", {{"ks", {1}}, {"n", {1}}}, angle).value.x, 0.5 * (1 + std::cos(radians(angle))),
                    promised)
            << angle;
}

struct Published {
    double n;
    double shares[5]; ///< at 0, 30, 60, 80 and 89 degrees
};

/// Directional albedo of the highlight with the factor (n+2)/2 of energy and the cosine that the lecture leaves out,
/// six digits as published. Towards n -> infinity it is cos(angle): what a mirror's disc would bring without the cosine.
TEST(Albedo, OfTheNormalisedHighlightIsAsPublished)
{
    constexpr Published table[] = {{1, {1, .880843, .608998, .409945, .327085}},
                                   {10, {1, .866029, .504736, .228056, .131960}},
                                   {100, {1, .866025, .500000, .175233, .049125}},
                                   {1000, {1, .866025, .5, .173648, .023212}}};
    constexpr double at[] = {0, 30, 60, 80, 89};
    for (const Published& row : table)
        for (std::size_t i = 0; i < 5; ++i) {
            const double share = albedo("phong", {{"ks", {1}}, {"n", {row.n}}}, at[i]).value.x;
            EXPECT_NEAR(share * std::cos(radians(at[i])) * (row.n + 2) / 2, row.shares[i], 1e-6)
                << "n = " << row.n << ", " << at[i] << " degrees";
        }
}

/// With the factor (n+2)/2 a highlight above the horizon sends on what a mirror of reflectance ks does, at every n.
TEST(Albedo, OfASharpHighlightTendsToAMirrors)
{
    double before = 1.0;
    for (const double n : {1e2, 1e3, 1e4, 1e5}) {
        const double share = albedo("phong", {{"ks", {0.7}}, {"n", {n}}}, 80).value.x * (n + 2) / 2;
        const double apart = std::fabs(share - 0.7) / 0.7;
        EXPECT_LE(apart, std::fmax(before, promised)) << n;
        before = apart;
    }
    EXPECT_LE(before, promised);
}

/// Why the text of phong says that it is not passive at any n: without the cosine, grazing light is divided by nearly 0.
TEST(Albedo, OfEveryHighlightExceedsOneNearGrazing)
{
    for (const double n : {1.0, 40.0, 1e3, 1e4})
        EXPECT_GT(albedo("phong", {{"ks", {0.5}}, {"n", {n}}}, 89.99999).value.x, 1.0) << n;
    EXPECT_LT(albedo("phong", {{"ks", {0.5}}, {"n", {40}}}, 60).value.x, 0.05) << "and far from grazing it is small";
}

TEST(Albedo, KnowsItsError)
{
    for (const double angle : angles)
        for (const double n : {0.5, 40.0, 1e6}) {
            const Share share = albedo("phong", {{"ks", {1}}, {"n", {n}}}, angle);
            EXPECT_LE(share.error, promised * std::fmax(1.0, share.value.x)) << angle << " degrees, n = " << n;
        }
}

} // namespace
} // namespace reflectance::test
