// What the verbs `table info`, `sample` and `convert` share: which surface of a file, which grid, how a table is written.
#pragma once

#include "core/measured/load.h"
#include "core/measured/write.h"

#include <CLI/App.hpp>
#include <optional>
#include <string>

namespace reflectance::cli {

struct SourceOptions {
    std::string file;
    std::size_t surface = 1;
    std::optional<double> wavelength;
};

void addSourceOptions(CLI::App& verb, SourceOptions& options);
[[nodiscard]] Result<Measurement> measurementFrom(const SourceOptions& options);

struct GridOptions {
    std::string grid; ///< empty: what suits the file that is written
    std::string interpolation = "linear";
};

void addGridOptions(CLI::App& verb, GridOptions& options);

/// "polar[:THETAS]", "isotropic[:THETASxPHIS]", "half[:HxDxP]"; each count at least 2.
[[nodiscard]] Result<GridShape> parseGrid(const std::string& text);

[[nodiscard]] Interpolation interpolationNamed(const std::string& name);

/// Writes the table in the format of the path's ending.
[[nodiscard]] Result<void> saveTable(const std::string& path, TableFormat format, const Table& table);

/// "isotropic, 31 x 31 x 37".
[[nodiscard]] std::string shapeText(const Table& table);

} // namespace reflectance::cli
