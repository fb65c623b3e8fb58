// Runs the trade that the workbench asks for, and lays its pictures over the view.
#pragma once

#include "app/explorer/screen_texture.h"
#include "app/explorer/trade_study.h"
#include "app/explorer/worker.h"
#include "core/study/trade/trade_run.h"

#include <memory>
#include <optional>

namespace reflectance::explorer {

struct Session;

/// CPU steps that were done in one go.
struct TradeSteps {
    bool more = false;
    std::string problem;
    std::shared_ptr<const Trade> trade;
};

/// What lies over the view now.
struct TradeLaid {
    TradeOverlay kind = TradeOverlay::None;
    std::optional<std::size_t> candidate;
    double tolerance = 0.0;

    friend bool operator==(const TradeLaid&, const TradeLaid&) = default;
};

struct Trades {
    Trades(GetProcAddress load, const std::function<void()>& wake)
        : steps(wake), picture(wake), map(wake), terms(wake), recheck(wake), overlay(load, Enlarged::Squares)
    {
    }

    Scene scene; ///< that is or was measured
    RenderSettings settings;
    std::unique_ptr<TradeRun> run; ///< kept after its end, for its truth and its workshop
    Worker<TradeSteps> steps;      ///< works on `run`, which nobody else touches meanwhile
    Worker<Image> picture;         ///< of a CPU candidate; works on `run`, too
    Worker<SufficientMap> map;
    Worker<TermBars> terms;
    Worker<ErrorFigures> recheck;       ///< of the shown candidate, once a changed scene rests
    std::uint64_t recheckedPicture = 0; ///< Viewport::pictures that it was asked of
    TradeLaid pictureOf, laid;          ///< what `picture` makes, and what is in `overlay`
    double mappedTolerance = -1.0;
    Metric mappedMetric = Metric::Max;
    ScreenTexture overlay;
};

/// With every frame, after the lens has had its say.
void pollTrade(Session& session);

} // namespace reflectance::explorer
