// The figures of a sweep as CSV, one line a cell, in the order of the cells: what is there is done.
#pragma once

#include "core/study/crew/journal.h"
#include "core/study/sweep/figures.h"

#include <string>
#include <utility>

namespace reflectance {

/// What a line says after its inputs: figures, or why there are none.
struct CellResult {
    Figures figures;
    std::string error = {}; ///< empty: computed
};

/// The head of the table; with `timing` there is a column of milliseconds.
[[nodiscard]] std::string sheetHead(const Study& study, bool timing);

/// The inputs of a cell: its number, the axes, size, samples, renderer, and the digest of its scene; ends with a comma.
[[nodiscard]] std::string inputsOf(const Cell& cell);

/// The rest of the line, its end included. Everything but the milliseconds is the same on every run.
[[nodiscard]] std::string resultText(const CellResult& result, bool timing);

/// The journal of a sweep.
class Sheet {
public:
    /// Opens or begins the file; refuses one whose lines are not this study's.
    [[nodiscard]] static Result<Sheet> open(const std::string& path, const Study& study, bool timing);

    [[nodiscard]] std::uint64_t cellsDone() const { return journal_.lines(); }
    [[nodiscard]] std::uint64_t cellsFailed() const { return failed_; } ///< of those done

    /// `rest` is a resultText().
    [[nodiscard]] Result<void> append(const Cell& cell, const std::string& rest);

private:
    Sheet(Journal journal, std::uint64_t failed) : journal_(std::move(journal)), failed_(failed) {}

    Journal journal_;
    std::uint64_t failed_ = 0;
};

} // namespace reflectance
