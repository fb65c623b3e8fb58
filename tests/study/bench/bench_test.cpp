// What a bench does to arrive at its figures; never the figures, which belong to a machine and a moment.
#include "core/geometry/load.h"
#include "core/reflectance/catalogue.h"
#include "core/study/bench/ball.h"
#include "core/study/bench/direction_rows.h"
#include "core/study/bench/growth.h"
#include "core/study/bench/interleaved.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

TEST(Interleaved, RunsEveryPieceInTurns)
{
    std::string order;
    const std::vector<TimedWork> works{byTheWall([&] { order += 'a'; }), byTheWall([&] { order += 'b'; })};
    Progress progress;
    const auto timings = interleaved(works, 3, 1.0, progress, 1.0);
    EXPECT_EQ(order, "abababab"); // once to warm up
    EXPECT_EQ(timings[0].repetitions, 3);
    EXPECT_NEAR(progress.done, 1.0, 1e-9);
}

TEST(Interleaved, StopsWhenItIsToldTo)
{
    Progress progress;
    int runs = 0;
    const std::vector<TimedWork> works{byTheWall([&] { progress.cancel = ++runs == 3; })};
    EXPECT_EQ(interleaved(works, 100, 1.0, progress, 1.0)[0].repetitions, 2);
    EXPECT_EQ(runs, 3);
}

TEST(Interleaved, TakesEachPiecesOwnClock)
{
    const std::vector<TimedWork> works{[] { return 3.0; }, [] { return 8.0; }};
    Progress progress;
    const auto timings = interleaved(works, 5, 2.0, progress, 1.0);
    EXPECT_EQ(timings[0].median, 1.5) << "of each of two units";
    EXPECT_EQ(timings[1].median, 4.0);
}

Growth grown(const std::function<double(double)>& cost)
{
    Growth growth{"triangles", "first frame", {}, {}};
    for (const double size : {10.0, 40.0, 160.0}) {
        growth.sizes.push_back(size);
        growth.milliseconds.push_back({cost(size), 0.1, 3});
    }
    return growth;
}

TEST(Growths, FitTheExponentOfAPower)
{
    EXPECT_NEAR(grown([](double n) { return 3.0 * n; }).exponent(), 1.0, 1e-12);
    EXPECT_NEAR(grown([](double n) { return 0.1 * n * n; }).exponent(), 2.0, 1e-12);
    EXPECT_NEAR(grown([](double) { return 5.0; }).exponent(), 0.0, 1e-12);
    // The planted opposite: a constant part flattens what is in proportion.
    EXPECT_LT(grown([](double n) { return 100.0 + n; }).exponent(), 0.6);
}

TEST(Growths, AreDrawnRelativeToTheSmallest)
{
    const Chart chart = chartOf({grown([](double n) { return 3.0 * n; })});
    EXPECT_EQ(chart.series[0].x, (std::vector<double>{1.0, 4.0, 16.0}));
    EXPECT_EQ(chart.series[0].y, (std::vector<double>{1.0, 4.0, 16.0}));
    EXPECT_EQ(chart.series[0].name, "triangles: first frame, exponent 1");
}

TEST(Ball, HasAboutAsManyTrianglesAsAsked)
{
    for (const std::size_t wanted : {100U, 1000U, 20000U}) {
        const auto mesh = ball(wanted);
        EXPECT_NEAR(static_cast<double>(mesh->triangles.size()), static_cast<double>(wanted),
                    0.2 * static_cast<double>(wanted));
    }
}

/// What is loaded is what was written: none dropped, none repaired but what six decimals round.
TEST(Ball, IsReadBackFromBothFormats)
{
    const auto mesh = ball(1000);
    for (const auto& [bytes, name] : {std::pair{objOf(*mesh), "ball.obj"}, std::pair{plyOf(*mesh), "ball.ply"}}) {
        const auto read = readMesh(bytes, name);
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_EQ(read.value().mesh->triangles.size(), mesh->triangles.size()) << name;
    }
}

TEST(DirectionRows, AreUnitVectorsUnderALightAbove)
{
    DirectionRows<double> rows(1000);
    const auto batch = rows.batch();
    int nearThePeak = 0;
    for (std::size_t i = 0; i < batch.count; ++i) {
        EXPECT_NEAR(dot(batch.V[i], batch.V[i]), 1.0, 1e-12);
        EXPECT_GE(dot(batch.N[i], batch.L[i]), 0.0);
        nearThePeak += dot(mirrored(batch.N[i], batch.L[i]), batch.V[i]) > 0.98 ? 1 : 0;
    }
    EXPECT_GE(nearThePeak, 500);
}

TEST(KernelCosts, CoverEveryModelInEveryPrecision)
{
    Progress progress;
    const auto costs = kernelCosts({64, 1}, progress);
    std::size_t models = 0;
    for (const Model& model : catalogue())
        models += model.text.usesTable ? 0 : 1;
    EXPECT_EQ(costs.size(), 3 * models + lobeForms().size() - 1);
    for (const KernelCost& cost : costs)
        EXPECT_GT(cost.nanoseconds.median, 0.0) << cost.model;
}

} // namespace
} // namespace reflectance
