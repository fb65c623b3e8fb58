// The front and what is chosen from it, on made-up figures.
#include "core/study/trade/trade.h"
#include "core/study/trade/trade_chart.h"
#include "core/study/trade/trade_page.h"

#include <gmock/gmock.h>
#include <random>

namespace reflectance::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Candidate made(std::vector<std::string> rungs, double error, double milliseconds)
{
    Candidate candidate;
    candidate.recipe.rungs = std::move(rungs);
    candidate.error.max = error;
    candidate.shade = {milliseconds, 0.1, 7};
    return candidate;
}

Trade sample()
{
    Trade trade;
    trade.candidates = {made({"double"}, 0.0, 9.0), made({"float"}, 1e-6, 10.0), made({"simd"}, 1e-6, 4.0),
                        made({"simd", "1_sample"}, 0.2, 1.0), made({"simd", "k_diagonal"}, 0.3, 2.0)};
    markFront(trade);
    return trade;
}

TEST(Front, HoldsWhatNothingElseBeats)
{
    const Trade trade = sample();
    EXPECT_THAT(frontOf(trade), ElementsAre(3, 2, 0));
    EXPECT_THAT(dominatedRungs(trade), ElementsAre("float", "k_diagonal"));
}

TEST(Front, OfTwoEqualOnesKeepsBoth)
{
    Trade trade;
    trade.candidates = {made({"simd"}, 0.1, 1.0), made({"glsl"}, 0.1, 1.0)};
    markFront(trade);
    EXPECT_EQ(frontOf(trade).size(), 2U) << "neither is better in anything";
}

TEST(Front, AgreesWithASweepOnRandomCandidates)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> small(0, 12);
    for (int round = 0; round < 200; ++round) {
        Trade trade;
        for (int i = 0; i < 30; ++i)
            trade.candidates.push_back(made({"simd"}, small(random), small(random)));
        markFront(trade);
        // Another way to the same: by rising cost, a candidate stays where its error is below all before, or equals the
        // lowest error of its own cost.
        for (const Candidate& c : trade.candidates) {
            double belowCost = HUGE_VAL, atCost = HUGE_VAL;
            for (const Candidate& other : trade.candidates) {
                if (other.shade.median < c.shade.median)
                    belowCost = std::min(belowCost, other.error.max);
                if (other.shade.median == c.shade.median)
                    atCost = std::min(atCost, other.error.max);
            }
            EXPECT_EQ(c.onFront, c.error.max < belowCost && c.error.max == atCost);
        }
    }
}

TEST(Choice, IsTheCheapestWithinATolerance)
{
    const Trade trade = sample();
    EXPECT_EQ(cheapestWithin(trade, 0.25), std::optional<std::size_t>(3));
    EXPECT_EQ(cheapestWithin(trade, 1e-6), std::optional<std::size_t>(2)) << "the tolerance itself is within";
    EXPECT_EQ(cheapestWithin(trade, 1e-7), std::optional<std::size_t>(0));
    Trade rough = trade;
    rough.candidates.erase(rough.candidates.begin());
    EXPECT_FALSE(cheapestWithin(rough, 1e-9));
}

TEST(Choice, IsTheMostExactWithinABudget)
{
    const Trade trade = sample();
    EXPECT_EQ(bestWithin(trade, 5.0), std::optional<std::size_t>(2));
    EXPECT_EQ(bestWithin(trade, 1.0), std::optional<std::size_t>(3));
    EXPECT_FALSE(bestWithin(trade, 0.5));
    EXPECT_EQ(chosen(trade, {{}, 1.0}), std::optional<std::size_t>(3));
    EXPECT_FALSE(chosen(trade, {}));
    EXPECT_THAT(findingsOf(trade, {{}, 0.5})[0], HasSubstr("the best that can be had is simd + 1_sample"));
}

TEST(Words, SayWhatIsGivenUp)
{
    const Trade trade = sample();
    EXPECT_EQ(givenUp(trade.candidates[0].recipe), "gives up nothing");
    EXPECT_THAT(givenUp(trade.candidates[3].recipe), HasSubstr("in lanes and smooth edges"));
    EXPECT_THAT(findingsOf(trade, {0.25, {}})[0], HasSubstr("simd + 1_sample"));
    EXPECT_THAT(findingsOf(trade, {1e-9, {}})[0], HasSubstr("double"));
    Trade rough = trade;
    rough.candidates.erase(rough.candidates.begin());
    EXPECT_THAT(findingsOf(rough, {1e-9, {}})[0], HasSubstr("the best that can be had is simd: 1e-06"));
}

TEST(Chart, ShowsEveryCandidateAndTheOneWithoutErrorToo)
{
    Trade trade = sample();
    trade.current = 0;
    const Chart chart = chartOf(trade, 0.01, true);
    std::size_t shown = 0;
    for (const Series& series : chart.series)
        if (series.mark == Mark::Dots && series.name != "what is drawn now")
            for (std::size_t i = 0; i < series.x.size(); ++i) {
                ++shown;
                EXPECT_GE(shareAlong(chart.x, series.x[i]), 0.0);
                EXPECT_LE(shareAlong(chart.x, series.x[i]), 1.0);
                EXPECT_GE(shareAlong(chart.y, series.y[i]), 0.0);
                EXPECT_LE(shareAlong(chart.y, series.y[i]), 1.0);
            }
    EXPECT_EQ(shown, trade.candidates.size());
    ASSERT_EQ(chart.guides.size(), 1U);
    EXPECT_EQ(chart.guides[0].at, 0.01);
}

TEST(Page, NeedsNothingBesideItself)
{
    Trade trade = sample();
    trade.skipped = {{"k_grey", "K <is> grey already"}};
    const std::string page = htmlOf(trade, {0.25, {}}, "reflectance trade mug");
    for (const Candidate& candidate : trade.candidates)
        EXPECT_THAT(page, HasSubstr('>' + nameOf(candidate.recipe) + '<'));
    EXPECT_THAT(page, HasSubstr("<svg"));
    EXPECT_THAT(page, HasSubstr("K &lt;is&gt; grey already"));
    EXPECT_THAT(page, testing::Not(HasSubstr("src=")));
    EXPECT_THAT(page, testing::Not(HasSubstr("href=")));
}

} // namespace
} // namespace reflectance::test
