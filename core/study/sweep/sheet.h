// The figures of a sweep as CSV, one line a cell, in the order of the cells: what is there is done.
#pragma once

#include "core/study/sweep/figures.h"

#include <string>

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

/// Appends lines to a file that an earlier run may have begun.
class Sheet {
public:
    /// Opens or begins the file, drops a torn last line, and refuses a file whose lines are not this study's.
    [[nodiscard]] static Result<Sheet> open(const std::string& path, const Study& study, bool timing);
    Sheet(Sheet&& other) noexcept;
    Sheet& operator=(Sheet&& other) noexcept;
    ~Sheet();

    [[nodiscard]] std::uint64_t cellsDone() const { return cells_; }
    [[nodiscard]] std::uint64_t cellsFailed() const { return failed_; } ///< of those done

    /// One write of the whole line.
    [[nodiscard]] Result<void> append(const Cell& cell, const CellResult& result);

private:
    Sheet(std::string path, bool timing) : path_(std::move(path)), timing_(timing) {}
    [[nodiscard]] Result<void> write(const std::string& line) const;

    std::string path_;
    bool timing_ = false;
    int file_ = -1;
    std::uint64_t cells_ = 0, failed_ = 0;
};

} // namespace reflectance
