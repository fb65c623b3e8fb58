// The tracer against what it must give: a flat surface its own model, grooves their closed forms, white facets all light.
#include "core/math/matrix3.h"
#include "core/reflectance/evaluate.h"
#include "tests/study/goniometer/bench.h"
#include "tests/study/goniometer/groove_theory.h"

#include <gtest/gtest.h>

namespace reflectance {
namespace {

/// Light, viewer, azimuth between: from the normal to grazing, towards and away from the light.
constexpr double places[][3] = {{30, 0, 0}, {30, 50, 180}, {60, 60, 0}, {60, 75, 120}, {80, 40, 180}, {85, 85, 60}};

/// Of numbers that are right, one in two million lies farther from the truth.
constexpr double sigmas = 5.0;

/// How far a traced mean is from theory, in standard errors; the theory's own quadrature errs by some 1e-4.
double farFrom(double theory, const Mean& traced)
{
    return std::fabs(traced.value - theory) / std::hypot(traced.error, 1e-4 + 3e-4 * theory);
}

TEST(MicroTracer, AFlatSurfaceReturnsItsFacetsModel)
{
    for (const char* id : {"lambert", "hybrid", "oren_nayar", "ggx", "blinn_phong", "eon"}) {
        const Facets facets = facetsNamed(id);
        const MicroTracer tracer = tracerOf("flat", facets, {true, true, 2});
        for (const auto& [thetaI, thetaR, phi] : places) {
            const DirectionPair at = pairAt(thetaI, thetaR, phi);
            const Vec3d expected =
                evaluate(*facets.model, facets.values,
                         std::vector<Observation>{{{0, 0, 1}, at.V, {{at.L, Vec3d(1.0)}}}}, Precision::Double)[0];
            const Vec3d traced = tracer.trace(at, std::nullopt, CounterRandom(1, 0, 0)).factor * Vec3d(1.0);
            // Every path sees the same but for the rounding of its turn, which lobes of n = 200 raise to some 1e-12.
            EXPECT_NEAR(traced.x, expected.x, 1e-11 + 1e-11 * expected.x) << id;
            EXPECT_NEAR(traced.z, expected.z, 1e-11 + 1e-11 * expected.z) << id;
        }
    }
}

TEST(MicroTracer, GroovesReflectOnceAsTorranceAndSparrowDerived)
{
    for (const double slope : {20.0, 45.0}) {
        const MicroTracer tracer =
            tracerOf("vgrooves:slope=" + std::to_string(slope), facetsNamed("lambert", {{"kd", {1.0}}}));
        for (const auto& [thetaI, thetaR, phi] : places) {
            const DirectionPair at = pairAt(thetaI, thetaR, phi);
            const Mean traced = meanOf(tracer, at, std::nullopt, 60);
            EXPECT_LT(farFrom(GrooveTheory{slope * degree}.once(at), traced), sigmas)
                << slope << " " << thetaI << " " << thetaR;
            EXPECT_EQ(traced.lost, 0U);
        }
    }
}

TEST(MicroTracer, AnOrientedSurfaceTurnsWithItsAzimuth)
{
    const MicroTracer tracer = tracerOf("vgrooves:slope=35", facetsNamed("lambert", {{"kd", {1.0}}}));
    for (const double azimuth : {0.0, 40.0, 90.0})
        for (const auto& [thetaI, thetaR, phi] : places) {
            const DirectionPair at = pairAt(thetaI, thetaR, phi);
            const double theory = GrooveTheory{35.0 * degree, azimuth * degree}.once(at);
            EXPECT_LT(farFrom(theory, meanOf(tracer, at, azimuth * degree, 20)), sigmas) << azimuth << " " << thetaI;
        }
}

TEST(MicroTracer, OneInterreflectionIsTheRadiosityOfTwoStrips)
{
    const Facets white = facetsNamed("lambert", {{"kd", {1.0}}});
    const MicroTracer tracer = tracerOf("vgrooves:slope=40", white, {true, true, 1});
    for (const auto& [thetaI, thetaR, phi] : places) {
        const DirectionPair at = pairAt(thetaI, thetaR, phi);
        const GrooveTheory theory{40.0 * degree};
        const double twice = theory.twice(at);
        const Mean traced = meanOf(tracer, at, std::nullopt, 60);
        // The kernel is steep at the edge: 100 x 100 midpoints err by less than half a per cent of what is reflected twice.
        EXPECT_NEAR(traced.value, theory.once(at) + twice, sigmas * traced.error + 1e-4 + 5e-3 * twice) << thetaI;
    }
}

TEST(MicroTracer, ALeftOutMaskIsCaught)
{
    const MicroTracer faulty = tracerOf("vgrooves:slope=40", facetsNamed("lambert", {{"kd", {1.0}}}), {false, true, 0});
    const DirectionPair grazing = pairAt(30, 80, 180);
    EXPECT_GT(farFrom(GrooveTheory{40.0 * degree}.once(grazing), meanOf(faulty, grazing, std::nullopt, 60)),
              3 * sigmas);
}

TEST(MicroTracer, ALeftOutShadowIsCaught)
{
    const MicroTracer faulty = tracerOf("vgrooves:slope=40", facetsNamed("lambert", {{"kd", {1.0}}}), {true, false, 0});
    const DirectionPair grazing = pairAt(80, 30, 0);
    EXPECT_GT(farFrom(GrooveTheory{40.0 * degree}.once(grazing), meanOf(faulty, grazing, std::nullopt, 60)),
              3 * sigmas);
}

TEST(MicroTracer, WhiteFacetsKeepAllLight)
{
    const Facets white = facetsNamed("lambert", {{"kd", {1.0}}});
    for (const char* surface : {"vgrooves:slope=50", "gaussian:sigma=25,cells=64,correlation=0.1"}) {
        const MicroTracer tracer = tracerOf(surface, white, {true, true, 300});
        for (const double theta : {0.0, 50.0, 85.0}) {
            Vec3d sum;
            for (std::uint64_t batch = 0; batch < 8; ++batch)
                sum += tracer.furnace(pairAt(0, theta, 0).V, std::nullopt, CounterRandom(1, 7, batch)) / 8.0;
            // cosine-distributed bounces weigh exactly 1; after 300 of them none of 2048 paths is left inside.
            EXPECT_NEAR(sum.x, 1.0, 1e-9) << surface << " " << theta;
        }
    }
}

TEST(MicroTracer, IsReciprocal)
{
    const MicroTracer tracer =
        tracerOf("gaussian:sigma=30,cells=64,correlation=0.1", facetsNamed("lambert"), {true, true, 3});
    for (const auto& [thetaI, thetaR, phi] : places) {
        const DirectionPair at = pairAt(thetaI, thetaR, phi);
        const DirectionPair back{at.V, at.L};
        const Mean there = meanOf(tracer, at, std::nullopt, 60, 1);
        const Mean again = meanOf(tracer, back, std::nullopt, 60, 2);
        const double difference = there.value / at.L.z - again.value / back.L.z;
        EXPECT_LT(std::fabs(difference), sigmas * std::hypot(there.error / at.L.z, again.error / back.L.z)) << thetaI;
    }
}

TEST(MicroTracer, CarriesAWholeMatrixThroughInterreflection)
{
    // A permutation: what is reflected twice has its channels exchanged once more.
    const Facets facets = facetsNamed("lambert_color", {{"K", {0, 1, 0, 0, 0, 1, 1, 0, 0}}});
    ASSERT_EQ(facets.channels, 9U);
    const DirectionPair at = pairAt(40, 30, 90);
    const auto factor =
        tracerOf("vgrooves:slope=45", facets, {true, true, 1}).trace(at, 0.3, CounterRandom(1, 0, 0)).factor;
    const GrooveTheory theory{45.0 * degree, 0.3};
    // One batch of 256 paths; each entry a mean of numbers below 2.
    EXPECT_NEAR(factor.rows[0].y, theory.once(at), 0.05);
    EXPECT_NEAR(factor.rows[0].z, theory.twice(at), 0.05);
    EXPECT_GT(factor.rows[0].z, 0.02);
    EXPECT_EQ(factor.rows[0].x, 0.0);
}

TEST(MicroTracer, ItsStandardErrorIsHonest)
{
    const MicroTracer tracer = tracerOf("vgrooves:slope=35", facetsNamed("lambert", {{"kd", {1.0}}}));
    const DirectionPair at = pairAt(60, 60, 60);
    const double theory = GrooveTheory{35.0 * degree}.once(at);
    double squares = 0.0;
    constexpr int runs = 200;
    for (int seed = 0; seed < runs; ++seed) {
        const Mean mean = meanOf(tracer, at, std::nullopt, 16, static_cast<std::uint64_t>(seed));
        squares += std::pow((mean.value - theory) / mean.error, 2) / runs;
    }
    // Student's t with 15 degrees of freedom has variance 1.15; the mean of 200 squares spreads by 0.13.
    EXPECT_GT(squares, 0.65);
    EXPECT_LT(squares, 1.75);
}

} // namespace
} // namespace reflectance
