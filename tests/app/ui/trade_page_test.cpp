// The trade's page: every control explains itself, a dot can be clicked, the tolerance line dragged.
#include "app/explorer/state.h"
#include "app/explorer/ui/workbench/trade_page.h"
#include "tests/app/ui/sweep.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

const ImVec2 corner{0.0F, 0.0F};
const ImVec2 benchSize{1100.0F, 320.0F};

Candidate made(std::vector<std::string> rungs, double error, double milliseconds)
{
    Candidate candidate;
    candidate.recipe.rungs = std::move(rungs);
    candidate.error.max = error;
    candidate.shade = {milliseconds, milliseconds / 20.0, 7};
    return candidate;
}

ExplorerState measuredState()
{
    ExplorerState state;
    state.scene = defaultScene();
    auto trade = std::make_shared<Trade>();
    trade->candidates = {made({"double"}, 1e-3, 30.0), made({"simd"}, 2e-3, 8.0), made({"simd", "1_sample"}, 0.3, 1.0),
                         made({"float"}, 2e-3, 40.0)};
    trade->skipped = {{"k_grey", "K is grey already"}};
    markFront(*trade);
    state.trade.trade = trade;
    return state;
}

class TradePage : public testing::Test {
protected:
    Stage::Draw drawn()
    {
        return [this] {
            ImGui::SetNextWindowPos(corner);
            ImGui::SetNextWindowSize(benchSize);
            ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
            drawTradePage(state);
            ImGui::End();
        };
    }

    Stage stage{benchSize.x, benchSize.y};
    ExplorerState state = measuredState();
};

TEST_F(TradePage, ExplainsEveryControlInEveryDetail)
{
    for (const TradeDetail detail : {TradeDetail::Candidate, TradeDetail::Terms, TradeDetail::Findings}) {
        state.trade.detail = detail;
        const Faults faults = sweep(stage, corner, benchSize, {18.0F, 10.0F}, drawn());
        EXPECT_TRUE(faults.shared.empty()) << "two controls share an identity";
        EXPECT_TRUE(faults.silent.empty()) << faults.silent.size() << " controls without a tooltip";
        EXPECT_GT(faults.controls, 8U);
    }
}

TEST_F(TradePage, TheDialChoosesUntilADotIsClicked)
{
    state.trade.tolerance = 0.01;
    stage.frame(drawn());
    EXPECT_EQ(state.trade.shown(), std::optional<std::size_t>(1));
    for (float x = 300.0F; x < 760.0F && !state.trade.selected; x += 6.0F)
        for (float y = 30.0F; y < 280.0F && !state.trade.selected; y += 6.0F)
            stage.click({x, y}, drawn());
    EXPECT_TRUE(state.trade.selected) << "no dot could be clicked";
    EXPECT_EQ(state.trade.shown(), state.trade.selected);
}

TEST_F(TradePage, TheToleranceLineFollowsTheMouse)
{
    state.trade.tolerance = 0.02;
    const double before = state.trade.tolerance;
    for (float y = 30.0F; y < 280.0F && !state.trade.holdsTolerance; y += 4.0F) {
        stage.moveTo({520.0F, y});
        stage.hold(false);
        stage.frame(drawn());
        stage.hold(true);
        stage.frame(drawn());
    }
    ASSERT_TRUE(state.trade.holdsTolerance) << "the line is met by no row of the chart";
    stage.moveTo({520.0F, ImGui::GetIO().MousePos.y - 30.0F});
    stage.frame(drawn());
    EXPECT_GT(state.trade.tolerance, before);
    stage.hold(false);
    stage.frame(drawn());
    EXPECT_FALSE(state.trade.holdsTolerance);
}

TEST_F(TradePage, AsksForWhatItsButtonSays)
{
    stage.click({60.0F, 20.0F}, drawn());
    EXPECT_TRUE(state.trade.asked);
    EXPECT_FALSE(state.trade.stopped);
}

} // namespace
} // namespace reflectance::explorer
