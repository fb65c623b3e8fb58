// The extremes, tried hazard by hazard between frames: GLSL's rows ask the window's own driver, so they run on its thread.
#pragma once

#include "core/study/extremes/extremes.h"
#include "core/study/extremes/sweep.h"

#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// How its page is looked at.
struct ExtremesPage {
    bool onlyFailures = false;
    bool losses = false;                 ///< the second table: where three digits are lost
    std::optional<std::size_t> selected; ///< index into the findings
};

struct ExtremesStudy {
    std::vector<Finding> findings;
    std::vector<std::string> ids;      ///< of all hazards, in their order; empty before the first run
    std::size_t tried = 0;             ///< how many of them
    std::vector<SweepRow> losses;      ///< where three digits are lost
    std::vector<SweepTask> lossesToGo; ///< last one first
    std::size_t lossesInAll = 0;
    bool running = false;

    void start();
    [[nodiscard]] float done() const; ///< 0 .. 1

    /// Tries the next hazard, then the next row of losses; the last one ends the run.
    void step(const Instruments& instruments);
};

} // namespace reflectance::explorer
