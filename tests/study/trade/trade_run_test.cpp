// A whole trade on a small scene: every candidate is measured, the truth is the truth, and it can be stopped.
#include "core/render/headless/headless_context.h"
#include "core/study/trade/rung.h"
#include "core/study/trade/trade_run.h"
#include "tests/study/trade/scenes.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <set>

namespace reflectance::test {
namespace {

using testing::HasSubstr;

TradeOptions quick()
{
    TradeOptions options;
    options.repetitions = 1;
    return options;
}

const Candidate* named(const Trade& trade, const std::vector<std::string>& rungs)
{
    const auto found = std::find_if(trade.candidates.begin(), trade.candidates.end(),
                                    [&](const Candidate& c) { return c.recipe.rungs == rungs; });
    return found == trade.candidates.end() ? nullptr : &*found;
}

class WholeTrade : public testing::Test {
protected:
    void SetUp() override
    {
        auto context = openHeadless(ContextKind::Any);
        ASSERT_TRUE(context) << context.error().sentence();
        context_ = *std::move(context);
        auto renderer = GlRenderer::create(context_->loader());
        ASSERT_TRUE(renderer) << renderer.error().sentence();
        gl_.emplace(*std::move(renderer));
    }

    std::unique_ptr<HeadlessContext> context_;
    std::optional<GlRenderer> gl_;
};

TEST_F(WholeTrade, MeasuresEveryCandidateInBothRenderers)
{
    const auto trade = measuredTrade(shinyScene(), smallSettings, quick(), &*gl_);
    ASSERT_TRUE(trade) << trade.error().sentence();
    std::set<std::vector<std::string>> seen;
    bool composed = false;
    for (const Candidate& candidate : trade->candidates) {
        EXPECT_TRUE(seen.insert(candidate.recipe.rungs).second) << nameOf(candidate.recipe) << " twice";
        EXPECT_GE(candidate.shade.repetitions, 1) << nameOf(candidate.recipe);
        EXPECT_GT(candidate.bytes, 0U);
        EXPECT_GT(candidate.error.max, 0.0) << "none of these has the truth's samples";
        // A promise is about its own renderer's picture before; floats add their own 1e-5.
        EXPECT_LE(candidate.change, candidate.bound.value_or(HUGE_VAL) + 1e-5) << nameOf(candidate.recipe);
        std::set<RungAxis> axes;
        for (std::size_t i = 1; i < candidate.recipe.rungs.size(); ++i)
            EXPECT_TRUE(axes.insert(findRung(candidate.recipe.rungs[i])->axis).second)
                << nameOf(candidate.recipe) << ": two rungs of one axis";
        composed = composed || candidate.recipe.rungs.size() > 2;
    }
    EXPECT_TRUE(composed) << "combinations are tried, too";
    EXPECT_NE(named(*trade, {"simd", "k_diagonal"}), nullptr);
    EXPECT_NE(named(*trade, {"glsl", "half_buffer"}), nullptr);
    EXPECT_FALSE(frontOf(*trade).empty());
    ASSERT_TRUE(trade->current);
    EXPECT_EQ(nameOf(trade->candidates[*trade->current].recipe), "glsl");
    EXPECT_TRUE(std::any_of(trade->skipped.begin(), trade->skipped.end(),
                            [](const SkippedRung& s) { return s.rung == "one_colour_around"; }));
}

TEST(Trade, TheTruthHasNoError)
{
    TradeOptions options = quick();
    options.only = {"64_samples"};
    TradeRun run(shinyScene(), smallSettings, options, nullptr);
    while (*run.step())
        ;
    Recipe exact{shinyScene(), smallSettings};
    ASSERT_TRUE(applyRung(*findRung("64_samples"), exact).skipped.empty());
    const auto prepared = run.workshop().prepare(exact);
    const ErrorFigures error = run.judge()->errorOf(*run.workshop().picture(*prepared));
    EXPECT_EQ(error.max, 0.0);
    EXPECT_EQ(error.perceived.deltaEMax, 0.0);
    EXPECT_GT(named(run.trade(), {"simd"})->error.max, 1e-3) << "the planted fault: four samples are not the truth";
    // Of 64 equal places the SIMD sum is off by float arithmetic: (16 + 9 sqrt(30.5)) 2^-24 of lights below 2.
    EXPECT_LT(named(run.trade(), {"simd", "64_samples"})->error.max, 1e-5);
}

TEST(Trade, WithoutAPixelOfTheObjectIsAnError)
{
    Scene scene = shinyScene();
    scene.camera.target = {0.0, 50.0, 0.0};
    const auto trade = measuredTrade(scene, smallSettings, quick(), nullptr);
    ASSERT_FALSE(trade);
    EXPECT_THAT(trade.error().message, HasSubstr("no pixel shows the object"));
}

TEST(Trade, StopsWhenAsked)
{
    Progress progress;
    progress.cancel = true;
    const auto trade = measuredTrade(shinyScene(), smallSettings, quick(), nullptr, &progress);
    ASSERT_FALSE(trade);
    EXPECT_THAT(trade.error().message, HasSubstr("stopped"));
}

TEST(Trade, GoesForwardAndEnds)
{
    TradeRun run(shinyScene(), smallSettings, quick(), nullptr);
    double before = -1.0;
    for (bool more = true; more; more = *run.step()) {
        EXPECT_FALSE(run.nextUsesGl());
        EXPECT_GE(run.done(), before);
        before = run.done();
    }
    EXPECT_EQ(run.done(), 1.0);
    EXPECT_FALSE(*run.step()) << "and nothing is left";
}

} // namespace
} // namespace reflectance::test
