// The colour matrix K as one number, as a diagonal, or in full: which mode a matrix is in, and changing it without
// loss.
// Matrices are nine numbers, row by row: row i is what sensor i sees of each light primary.
#pragma once

#include "app/explorer/ui/panel_memory.h"

#include <span>
#include <string>
#include <vector>

namespace reflectance::explorer {

using MatrixValues = std::array<double, 9>;

/// The narrowest mode that holds the matrix.
[[nodiscard]] MatrixMode narrowestMode(const MatrixValues& K);

/// The mode in use: the one picked, unless the matrix has outgrown it.
[[nodiscard]] MatrixMode modeOf(const MatrixValues& K, const MatrixMemory& memory);

/// The matrix after the user picked a mode. Narrowing remembers what it drops: Diagonal keeps the diagonal, Scalar the
/// diagonal's mean. Widening restores it; a diagonal whose mean was changed meanwhile keeps its proportions.
[[nodiscard]] MatrixValues switched(const MatrixValues& K, MatrixMode mode, MatrixMemory& memory);

/// Sum of |off-diagonal| over sum of |diagonal|: the size of what a diagonal K leaves out. 0 for a zero diagonal.
[[nodiscard]] double offDiagonalShare(const MatrixValues& K);

/// What one should know about these values, as sentences: rows that return more than arrives, negative entries.
[[nodiscard]] std::vector<std::string> matrixRemarks(const MatrixValues& K);

} // namespace reflectance::explorer
