// The sweep: every cell of a study computed once, by all cores or by all ranks of mpirun, written in order. Stopped or killed,
// it goes on where it was.
#pragma once

#include "core/render/progress.h"
#include "core/study/sweep/sheet.h"

#include <string>

namespace reflectance {

struct SweepOptions {
    std::string out;      ///< CSV
    std::string pictures; ///< folder for cell_0.png and so on; empty: none
    bool timing =
        false; ///< a column of milliseconds; cells then run one after the other, for they would disturb each other
    unsigned workers = 0; ///< processes in each rank, each with a cell at a time; 0: one per core
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
/// computed, or whose process dies of it, has its reason in the column `error`, and the sweep goes on. In a rank that is not the
/// first this works for the first and gives nothing but zeros.
[[nodiscard]] Result<SweepOutcome> sweep(const Study& study, const SweepOptions& options, Progress* progress = nullptr);

} // namespace reflectance
