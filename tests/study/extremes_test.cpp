// The hazards H01 to H74 hold in the shipped program, and the runner finds faults that are planted.
#include "core/render/gl/gl_renderer.h"
#include "core/study/extremes/extremes.h"
#include "core/study/extremes/sweep.h"
#include "core/study/extremes/textbook.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <set>

namespace reflectance::test {
namespace {

/// One context and one run for all tests: they only look at what it found.
class Extremes : public testing::Test {
protected:
    static void SetUpTestSuite()
    {
        auto opened = openHeadless(ContextKind::Any);
        ASSERT_TRUE(opened) << opened.error().sentence();
        context_ = *std::move(opened);
        auto renderer = GlRenderer::create(context_->loader());
        ASSERT_TRUE(renderer) << renderer.error().sentence();
        gl_ = *std::move(renderer);
    }
    static void TearDownTestSuite()
    {
        gl_.reset();
        context_.reset();
    }
    static Instruments ours() { return programInstruments(&*gl_); }

private:
    static inline std::unique_ptr<HeadlessContext> context_;
    static inline std::optional<GlRenderer> gl_;
};

/// "H04 double" and so on: what failed.
std::set<std::string> failures(const std::vector<Finding>& findings)
{
    std::set<std::string> failed;
    for (const Finding& finding : findings)
        if (finding.verdict == Verdict::Fail)
            failed.insert(finding.id + " " + finding.arithmetic);
    return failed;
}

TEST_F(Extremes, EveryApplicableHazardHolds)
{
    const auto findings = runExtremes(ours());
    for (const Finding& f : findings) {
        EXPECT_NE(f.verdict, Verdict::Fail) << f.id << ' ' << f.arithmetic << ": " << f.input << "\n  expected "
                                            << f.expected << "\n  found " << f.found;
        EXPECT_NE(f.verdict, Verdict::NotRun) << f.id;
        EXPECT_FALSE(f.found.empty()) << f.id;
    }
    EXPECT_GT(summaryOf(findings).passed, 100U);
}

TEST_F(Extremes, AllFortySevenStandInTheTable)
{
    // The reference numbers them with gaps: 9 of the lobe, 9 of vectors and meshes, and so on.
    const auto ids = hazardIds();
    const std::vector<std::pair<int, int>> runs{{1, 18}, {20, 24}, {30, 36}, {40, 43}, {50, 54}, {60, 62}, {70, 74}};
    std::vector<std::string> expected;
    for (const auto& [first, last] : runs)
        for (int i = first; i <= last; ++i)
            expected.push_back((i < 10 ? "H0" : "H") + std::to_string(i));
    EXPECT_EQ(ids, expected);
    EXPECT_EQ(ids.size(), 47U);
}

TEST_F(Extremes, OneCanBeChosen)
{
    const auto findings = runExtremes(ours(), "H42");
    ASSERT_EQ(findings.size(), 4U);
    EXPECT_EQ(findings[3].arithmetic, "glsl");
    EXPECT_TRUE(runExtremes(ours(), "H99").empty());
}

TEST_F(Extremes, WithoutAContextGlslIsNotCountedAsPassed)
{
    const auto findings = runExtremes(programInstruments(nullptr, "no driver"), "H01");
    const ExtremesSummary summary = summaryOf(findings);
    EXPECT_EQ(summary.passed, 3U);
    EXPECT_EQ(summary.notRun, 1U);
    EXPECT_EQ(findings.back().found, "no driver");
}

/// The planted fault: the power of a dot product.
TEST_F(Extremes, ATextbookLobeIsFound)
{
    const auto failed = failures(runExtremes(textbookInstruments(ours())));
    for (const char* fault : {"H04 double", "H04 float", "H04 simd", "H04 glsl", "H05 double", "H05 float", "H05 glsl",
                              "H08 float", "H08 glsl", "H10 double", "H11 float", "H12 double"})
        EXPECT_TRUE(failed.contains(fault)) << fault;
}

TEST_F(Extremes, TheSweepTellsOursFromTheTextbook)
{
    for (const SweepRow& row : sweepExtremes(ours())) {
        const double ours = row.ours.value_or(row.last);
        const double textbook = row.textbook.value_or(row.last);
        if (row.swept.starts_with("n at")) {
            ASSERT_TRUE(row.textbook) << row.model << ' ' << row.arithmetic;
            EXPECT_GE(ours, 100.0 * textbook) << row.model << ' ' << row.swept << ' ' << row.arithmetic;
        }
        if (row.swept.starts_with("length")) {
            EXPECT_FALSE(row.ours) << row.model << ' ' << row.arithmetic;
            EXPECT_TRUE(row.textbook) << row.model << ' ' << row.arithmetic;
        }
    }
}

} // namespace
} // namespace reflectance::test
