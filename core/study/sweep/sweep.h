// The sweep: every cell of a study computed once, by all cores, written in order. Stopped or killed, it goes on where it was.
#pragma once

#include "core/render/progress.h"
#include "core/study/sweep/sheet.h"

#include <map>
#include <optional>
#include <string>

namespace reflectance {

struct SweepOptions {
    std::string out;      ///< CSV
    std::string pictures; ///< folder for cell_0.png and so on; empty: none
    bool timing =
        false; ///< a column of milliseconds; cells then run one after the other, for they would disturb each other
    unsigned workers = 0; ///< cells at a time; 0: one per core
};

struct SweepOutcome {
    std::uint64_t cells = 0, before = 0, failed = 0; ///< of the study; already there; of all that are there
};

/// What the whole study will take, from its first cell that is not there yet.
struct SweepEstimate {
    double seconds = 0.0; ///< on this machine, all cores
    double bytes = 0.0;   ///< of figures and pictures
};

/// Computes one cell and writes nothing.
[[nodiscard]] SweepEstimate estimated(const Study& study, const SweepOptions& options);

/// The Error says what could not be written, or that the sweep was stopped and after how many cells. A cell that cannot be
/// computed has its reason in the column `error`, and the sweep goes on.
[[nodiscard]] Result<SweepOutcome> sweep(const Study& study, const SweepOptions& options, Progress* progress = nullptr);

/// What a worker does with a cell: computes it, saves its picture, and never throws. Stopped: nothing.
[[nodiscard]] std::optional<CellResult> workOn(const Cell& cell, const Study& study, const SweepOptions& options,
                                               Progress* progress);

/// Takes results in any order and appends them in theirs.
class InOrder {
public:
    InOrder(const Study& study, Sheet& sheet) : study_(&study), sheet_(&sheet) {}
    [[nodiscard]] Result<void> take(std::uint64_t cell, CellResult result);

private:
    const Study* study_;
    Sheet* sheet_;
    std::map<std::uint64_t, CellResult> waiting_;
};

} // namespace reflectance
