// The trade as the workbench asks for it and gets it back. CPU work runs on a thread of its own, the window's driver is asked
// between frames.
#pragma once

#include "core/study/trade/sufficient.h"
#include "core/study/trade/terms.h"
#include "core/study/trade/trade.h"

#include <memory>
#include <optional>
#include <string>

namespace reflectance::explorer {

/// What lies over the view.
enum class TradeOverlay { None, Picture, Difference, Map };

/// What the page shows beside its chart.
enum class TradeDetail { Candidate, Terms, Findings };

struct TradeStudy {
    // What the page wishes; the frame loop does it.
    bool asked = false, stopped = false;
    Metric metric = Metric::Max;
    bool byTime = false; ///< the dial is a budget of milliseconds, else a tolerance
    double tolerance = 0.02, milliseconds = 5.0;
    TradeOverlay overlay = TradeOverlay::None;
    TradeDetail detail = TradeDetail::Candidate;
    std::optional<std::size_t> selected; ///< a candidate, by a click; none: the dial's choice
    bool holdsTolerance = false;         ///< the mouse has the line

    // What the frame loop knows.
    bool running = false, mapping = false;
    double done = 0.0;
    std::shared_ptr<const Trade> trade; ///< as far as it is measured
    bool stale = false;                 ///< the scene has changed since
    bool rechecking = false;
    std::optional<double> rechecked; ///< the shown candidate's error on the changed scene
    std::shared_ptr<const SufficientMap> map;
    bool termsAsked = false; ///< the page wants the terms by themselves, without the candidates
    bool measuringTerms = false;
    std::shared_ptr<const TermBars> terms;
    std::string problem; ///< why there is no trade

    [[nodiscard]] Wanted wanted() const;
    /// The candidate that the page speaks of: the selected one, else the dial's choice; none before there is one.
    [[nodiscard]] std::optional<std::size_t> shown() const;
};

/// The view's size as it is measured: as it is up to a third of a megapixel, else smaller in the same proportion.
[[nodiscard]] RenderSettings measuredSettings(const RenderSettings& view);

/// Whether two scenes make the same picture; names and files do not count.
[[nodiscard]] bool looksTheSame(const Scene& a, const Scene& b);

} // namespace reflectance::explorer
