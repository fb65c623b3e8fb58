// Models as tables: the numbers are the model's, in every number of channels.
#include "core/study/tables/sample_model.h"

#include "core/reflectance/evaluate.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

const Model& model(std::string_view id)
{
    return **findModel(id);
}

/// The factor that the model gives for light I, over pi N.L.
Vec3d brdf(const Model& m, const std::vector<double>& values, const DirectionPair& at, const Vec3d& I)
{
    const Observation row{{0, 0, 1}, at.V, {{at.L, I}}};
    return evaluate(m, values, {&row, 1}, Precision::Double).front() / (pi * at.L.z);
}

TEST(SampledModel, TakesAsManyChannelsAsTheModelNeeds)
{
    const Model& hybrid = model("hybrid");
    const auto with = [&](const std::vector<double>& K) {
        return channelsOf(hybrid, flatValues(hybrid.text, {{"K", K}, {"ks", {0.2}}}));
    };
    EXPECT_EQ(with({0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5}), 1U);
    EXPECT_EQ(with({0.5, 0, 0, 0, 0.4, 0, 0, 0, 0.5}), 3U);
    EXPECT_EQ(with({0.5, 0, 0, 0, 0.5, 0, -0.1, 0, 0.5}), 9U);
}

/// At its samples a table is the model; nodes are met through directions, which round.
TEST(SampledModel, IsTheModelAtItsSamples)
{
    const Model& hybrid = model("hybrid");
    const auto values = flatValues(hybrid.text, {{"K", {0.5, 0.1, 0, 0, 0.4, 0.2, -0.1, 0, 0.6}}, {"n", {20.0}}});
    const SampledModel sampled = sampledModel(hybrid, values, isotropicShape(10, 7), Interpolation::Linear, 9);
    EXPECT_EQ(sampled.table.channels, 9U);
    const Vec3d I{1.0, 0.5, 0.25};
    for (int i = 0; i < 9; ++i)
        for (int r = 0; r < 9; ++r) {
            const DirectionPair at{directionAt(i * pi / 18.0, 0.0), directionAt(r * pi / 18.0, pi / 6.0 * 5.0)};
            const Vec3d expected = brdf(hybrid, values, at, I);
            const Vec3d found = *brdfAt(sampled.table, at.L, at.V) * I;
            EXPECT_NEAR(found.x, expected.x, 1e-12) << i << ' ' << r;
            EXPECT_NEAR(found.y, expected.y, 1e-12);
            EXPECT_NEAR(found.z, expected.z, 1e-12);
        }
}

TEST(SampledModel, WithoutRoomForAMatrixHoldsTheColourUnderWhite)
{
    const Model& lambert = model("lambert_color");
    const auto values = flatValues(lambert.text, {{"K", {0.5, 0.1, 0, 0, 0.4, 0.2, -0.1, 0, 0.6}}});
    const SampledModel sampled = sampledModel(lambert, values, isotropicShape(3, 3), Interpolation::Linear, 3);
    EXPECT_TRUE(sampled.isUnderWhite);
    EXPECT_NEAR(sampled.table.values[0], 0.6 / pi, 1e-15);
    EXPECT_NEAR(sampled.table.values[1], 0.6 / pi, 1e-15);
    EXPECT_NEAR(sampled.table.values[2], 0.5 / pi, 1e-15);
    EXPECT_FALSE(sampledModel(lambert, values, isotropicShape(3, 3), Interpolation::Linear, 9).isUnderWhite);
}

/// Phong's f is ks (R.V)^n / (pi cos(theta_i)): its error on a grid of step h is about n h^2 / 8 of the peak per angle.
TEST(SampledModel, StatesTheErrorOfItsGrid)
{
    const Model& phong = model("phong");
    const auto values = flatValues(phong.text, {{"n", {20.0}}});
    const double fine = sampledModel(phong, values, isotropicShape(91, 91), Interpolation::Linear, 9).error.rms;
    const double h = pi / 180.0;
    EXPECT_LT(fine, 3.0 * 20.0 * h * h / 8.0 * 4.0) << "three angles, the azimuth's step twice the others'";
    EXPECT_GT(sampledModel(phong, values, isotropicShape(7, 7), Interpolation::Linear, 9).error.rms, 10.0 * fine)
        << "a planted grid that is far too coarse";
}

} // namespace
} // namespace reflectance
