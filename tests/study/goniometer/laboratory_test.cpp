// Runs: the numbers are a function of the setup, wherever and however often they were stopped.
#include "core/measured/facts.h"
#include "core/study/goniometer/checkpoint.h"
#include "tests/study/goniometer/bench.h"
#include "tests/study/goniometer/groove_theory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace reflectance {
namespace {

LabSetup smallSetup()
{
    LabSetup setup;
    setup.surface = "vgrooves:slope=40";
    setup.values = {1.0};
    setup.effects.bounces = 1;
    setup.shape = labShape(5, 5, true);
    return setup;
}

struct Bench {
    LabSetup setup = smallSetup();
    MicroSurface surface = *microSurface(setup.surface);
    MicroTracer tracer{surface, facetsNamed("lambert", {{"kd", {1.0}}}), setup.effects};

    LabRun measured(const LabTargets& targets) const
    {
        LabRun run = startedRun(setup, surface.fingerprint());
        measure(run, tracer, targets);
        return run;
    }
};

TEST(Laboratory, ATableHoldsTheBrdfWithItsError)
{
    const Bench bench;
    const LabRun run = bench.measured({4096, {}, {}});
    const Table table = tableOf(run);
    const Table errors = errorsOf(run);
    ASSERT_TRUE(checkedTable(table));
    EXPECT_EQ(run.paths(), 5U * 5U * 5U * 4096U);
    EXPECT_EQ(run.lost, 0U);
    const GrooveTheory theory{40 * degree};
    for (std::size_t cell = 7; cell < run.cells.size(); cell += 23) {
        const DirectionPair at = directionsOf(run.setup, cell);
        const double f = (theory.once(at) + theory.twice(at)) / (std::numbers::pi * at.L.z);
        EXPECT_NEAR(table.values[cell], f, 5.0 * errors.values[cell] + 1e-4 + 2e-3 * f)
            << cell; // the theory's own quadrature
    }
}

TEST(Laboratory, DoesNotDependOnThreads)
{
    const Bench bench;
    const LabTargets targets{1024, 0.02, {}};
    const auto textWith = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return checkpointText(bench.measured(targets));
    };
    const std::string alone = textWith(1);
    EXPECT_EQ(alone, textWith(2));
    EXPECT_EQ(alone, textWith(5));
    Bench other;
    other.setup.seed = 2;
    EXPECT_NE(alone, checkpointText(other.measured(targets))) << "another seed";
}

TEST(Laboratory, AStoppedRunGoesOnAsIfItHadNot)
{
    const Bench bench;
    const LabTargets targets{2048, 0.015, {}};
    const std::string whole = checkpointText(bench.measured(targets));
    LabRun run = startedRun(bench.setup, bench.surface.fingerprint());
    int sittings = 0;
    for (bool stopped = true; stopped && sittings < 5000; ++sittings) {
        Progress progress;
        measure(run, bench.tracer, targets, &progress, [&](const LabRun&) { progress.cancel = true; });
        stopped = progress.cancel;
        run = *readCheckpoint(checkpointText(run), "run.lab");
    }
    EXPECT_GT(sittings, 2);
    EXPECT_EQ(whole, checkpointText(run));
}

TEST(Laboratory, RefinesWhereTheErrorIsLargest)
{
    const Bench bench;
    const LabRun even = bench.measured({1024, {}, {}});
    const LabRun refined = bench.measured({1024, 0.01, {}});
    EXPECT_GT(errorsFound(even).largest, 0.01);
    EXPECT_LE(errorsFound(refined).largest, 0.01);
    const auto [least, most] =
        std::minmax_element(refined.cells.begin(), refined.cells.end(),
                            [](const LabCell& a, const LabCell& b) { return a.batches < b.batches; });
    EXPECT_EQ(least->batches, 4U) << "some cells were good enough";
    EXPECT_GT(most->batches, 8U);
}

TEST(Laboratory, AnErrorOutOfReachEndsAtTheMostPaths)
{
    const Bench bench;
    LabTargets targets{1024, 1e-9, {}};
    targets.mostPaths = 2048;
    for (const LabCell& cell : bench.measured(targets).cells)
        EXPECT_LE(cell.batches, 8U);
}

TEST(Laboratory, ATimeThatIsOverStopsAtOnce)
{
    const Bench bench;
    EXPECT_EQ(bench.measured({1024, {}, 0.0}).paths(), 0U);
    EXPECT_TRUE(tableOf(bench.measured({1024, {}, 0.0})).isHole(0));
}

TEST(Laboratory, WhiteGroovesLoseOnlyWhatBouncesOn)
{
    Bench bench;
    bench.setup.shape = labShape(10, 10, true);
    bench.tracer = MicroTracer(bench.surface, facetsNamed("lambert", {{"kd", {1.0}}}), {true, true, 40});
    const Measurement table = tableOf(bench.measured({1024, {}, {}}));
    for (const double theta : {0.0, 40.0, 70.0}) {
        const Albedo albedo = albedoAt(table, theta * degree);
        // Interpolation between samples 10 and 20 degrees apart costs up to two per cent here.
        EXPECT_NEAR(albedo.value.x, 1.0, 0.03) << theta;
    }
}

TEST(Laboratory, RefusesFacetsWithoutABrdf)
{
    const Model& mirror = **findModel("mirror");
    const auto facets = facetsOf(mirror, flatValues(mirror.text, {}));
    ASSERT_FALSE(facets);
    EXPECT_THAT(facets.error().message, testing::HasSubstr("no BRDF"));
    const Model& table = **findModel("table");
    EXPECT_FALSE(facetsOf(table, flatValues(table.text, {})));
}

} // namespace
} // namespace reflectance
