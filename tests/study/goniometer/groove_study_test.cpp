// The study of Oren and Nayar's formula: its gaps have the sizes and signs that are known, and its page says them.
#include "core/study/goniometer/groove_study.h"
#include "core/study/goniometer/lobe_charts.h"
#include "tests/study/goniometer/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

const GrooveStudy& theStudy()
{
    static const GrooveStudy study = *studyGrooves({20.0}, 0.9, 7, {1024, {}, {}}, nullptr);
    return study;
}

TEST(GrooveStudy, TheFormulaIsNearerThanLambertAndInterreflectionIsSeen)
{
    const StudiedGrooves& g = theStudy().grooves.at(0);
    EXPECT_LT(g.onceAgainstFirst.rms, 0.5 * g.onceAgainstLambert.rms);
    EXPECT_GT(g.onceAgainstFirst.rms, 2.0 * g.onceAgainstFirst.noise) << "a fit to integrals is off by more than noise";
    EXPECT_GT(g.onceAgainstLambert.mean, 0.0) << "masking and shadowing take light";
    // Interreflection adds light: the traced mean rises from once to twice to often.
    const auto f = [](const LabRun& run) { return gapBetween(run, factorOf(**findModel("lambert"), {0.9})).mean; };
    EXPECT_GT(f(g.once), f(g.twice));
    EXPECT_GT(f(g.twice), f(g.often));
}

TEST(GrooveStudy, AGapOfNothingIsNothingAndAPlantedOneIsFound)
{
    LabSetup setup;
    setup.surface = "flat";
    setup.values = {0.5};
    setup.shape = labShape(4, 3, true);
    const MicroSurface flat = *microSurface("flat");
    LabRun run = startedRun(setup, flat.fingerprint());
    measure(run, MicroTracer(flat, facetsNamed("lambert", {{"kd", {0.5}}}), {}), {1024, {}, {}});
    const Model& lambert = **findModel("lambert");
    EXPECT_LT(gapBetween(run, factorOf(lambert, {0.5})).rms, 1e-12);
    const FormulaGap gap = gapBetween(run, factorOf(lambert, {0.55}));
    EXPECT_NEAR(gap.rms, 0.1, 1e-9);
    EXPECT_NEAR(gap.mean, 0.1, 1e-9);
    EXPECT_NEAR(gap.worst, 0.05, 1e-9) << "at theta_i = 0";
}

TEST(GrooveStudy, TheFirstTermIsLinearInTheAlbedo)
{
    const Model& full = **findModel("oren_nayar_full");
    const ParameterValues values{{"sigma", {0.5}}};
    const std::vector<DirectionPair> at{pairAt(50, 40, 100)};
    const double one = onceReflected(full, values, 1.0)(at)[0];
    EXPECT_NEAR(onceReflected(full, values, 0.3)(at)[0], 0.3 * one, 1e-12);
    EXPECT_LT(one, factorOf(full, flatValues(full.text, {{"rho", {1, 1, 1}}, {"sigma", {0.5}}}))(at)[0]);
}

TEST(GrooveStudy, ItsPageLinksItsDrawings)
{
    const std::string page = pageOf(theStudy(), "images/page-", "the command");
    for (const Drawing& drawing : drawingsOf(theStudy())) {
        EXPECT_THAT(page, testing::HasSubstr("images/page-" + drawing.name + ".svg"));
        EXPECT_THAT(svgOf(drawing.chart, 400, 300), testing::HasSubstr("traced, single")); // long names take two lines
    }
    EXPECT_THAT(page, testing::HasSubstr("| 20 | "));
}

TEST(LobeCharts, ShowThePlaneOfIncidenceWithErrorBars)
{
    const LabRun& run = theStudy().grooves.at(0).often;
    const std::size_t incidence = nearestIncidence(run.setup, 50 * degree);
    EXPECT_EQ(incidence, 3U) << "45 degrees of a grid in steps of 15";
    const Series series = tracedSeries(run, "traced", incidence, 0);
    ASSERT_EQ(series.x.size(), 13U);
    EXPECT_EQ(series.x.front(), -90.0);
    EXPECT_EQ(series.spread.size(), series.y.size());
    EXPECT_GT(series.y[3], series.y[9]) << "grooves send light back to where it came from";
    const PolarChart lobe = lobeChart(run, "traced", incidence, {});
    ASSERT_EQ(lobe.curves.size(), 1U);
    EXPECT_EQ(lobe.curves[0].spread.size(), 13U);
}

} // namespace
} // namespace reflectance
