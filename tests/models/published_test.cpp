// Figures of the models that others have published, or that follow from a closed form.
#include "core/math/lobe.h"
#include "tests/models/evaluated.h"
#include "tests/models/random_cases.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance::test {
namespace {

constexpr Vec3d up{0, 0, 1};

Vec3d at(double polar, double azimuth = 0.0)
{
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

double valueOf(const std::string& model, const ParameterValues& values, const Vec3d& L, const Vec3d& V)
{
    return evaluated(OracleCase{model, values, up, L, V}, Precision::Double).x;
}

/// pi D / (4 cos) with light and viewer both at this angle from N, so that F, G and V.H are 1.
double beckmann(double m, double angle)
{
    const double value =
        valueOf("cook_torrance", {{"m", {m}}, {"f0", {1}}, {"ks", {1}}, {"K", {0}}}, at(angle), at(angle));
    return value * 4.0 * std::cos(angle) / std::numbers::pi;
}

TEST(Published, BeckmannsDistribution)
{
    // Both figures come from float, good to half of 2^-23.
    EXPECT_NEAR(beckmann(0.1, 0.0) / 31.8309879, 1.0, 0x1p-24);
    EXPECT_NEAR(beckmann(0.1, 0.1) / 11.86709118, 1.0, 0x1p-24);
}

TEST(Published, SchlicksFresnelAndHowFarItIsOff)
{
    const double eighth = std::numbers::pi / 4.0;
    for (const std::string model : {"ggx", "cook_torrance"}) {
        ParameterValues values{{"ks", {1}}, {"K", {0}}, {"f0", {1}}};
        const double whole = valueOf(model, values, at(eighth), at(-eighth));
        values["f0"] = {0.04};
        const double share = valueOf(model, values, at(eighth), at(-eighth)) / whole;
        EXPECT_NEAR(share / 0.042069273124, 1.0, 1e-10) << model;
        // Fresnel's own value for glass of index 1.5 at 45 degrees: Schlick's is 16 % below it.
        EXPECT_NEAR(share / 0.050239911012, 0.837, 1e-3) << model;
    }
}

/// The largest difference between Blinn-Phong with 4n and Phong with n, for a light at this angle, over viewers given by
/// their distance from R and the direction in which they lie; 0 and pi are the plane of incidence.
double blinnAgainstPhong(double n, double incidence, const std::vector<double>& sides)
{
    const Vec3d L = at(incidence);
    std::vector<Observation> rows;
    for (int i = 0; i <= 900; ++i)
        for (const double side : sides) {
            const Vec3d V = tilted(mirrored(up, L), i * std::numbers::pi / 1800.0, side);
            if (V.z > 0.0)
                rows.push_back({up, V, {{L, {1, 1, 1}, 0.0}}});
        }
    const auto valuesOf = [&](const char* id, double exponent) {
        const Model& model = **findModel(id);
        const ParameterValues values{{"ks", {1}}, {"n", {exponent}}, {"K", {0}}};
        return evaluate(model, flatValues(model.text, values), rows, Precision::Double);
    };
    const auto blinn = valuesOf("blinn_phong", 4.0 * n);
    const auto phong = valuesOf("phong", n);
    double worst = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        worst = std::max(worst, std::fabs(blinn[i].x - phong[i].x));
    return worst;
}

TEST(Published, TheRuleOfFourHoldsInThePlaneOfIncidence)
{
    struct Figure {
        double n, error;
    };
    // With the light at N every plane is the plane of incidence. Two digits are printed.
    for (const auto& [n, error] :
         {Figure{1, 0.25}, Figure{5, 0.030}, Figure{10, 0.014}, Figure{50, 0.0027}, Figure{200, 6.8e-4}})
        EXPECT_NEAR(blinnAgainstPhong(n, 0.0, {0.0}) / error, 1.0, 0.04) << n;
}

TEST(Published, AndFailsAcrossIt)
{
    struct Figure {
        double degrees, error;
    };
    std::vector<double> around;
    for (int i = 0; i < 72; ++i)
        around.push_back(i * std::numbers::pi / 36.0);
    for (const auto& [degrees, error] : {Figure{30, 0.10}, Figure{60, 0.47}, Figure{80, 0.87}})
        EXPECT_NEAR(blinnAgainstPhong(50, degrees * std::numbers::pi / 180.0, around), error, 0.01) << degrees;
    EXPECT_NEAR(blinnAgainstPhong(50, 0.0, around), 0.003, 0.0005);
}

TEST(Published, RoughClayLooksFlat)
{
    // Light and viewer in one place: Lambert falls to cos(80 degrees) = 0.17 towards the rim, rough clay to a third.
    const ParameterValues clay{{"rho", {0.9}}, {"sigma", {0.5}}, {"kd", {0.9}}};
    const auto rim = [&](const char* model) {
        return valueOf(model, clay, at(1.396), at(1.396)) / valueOf(model, clay, up, up);
    };
    EXPECT_NEAR(rim("lambert"), 0.174, 0.001);
    EXPECT_GT(rim("oren_nayar"), 2.0 * rim("lambert"));
}

} // namespace
} // namespace reflectance::test
