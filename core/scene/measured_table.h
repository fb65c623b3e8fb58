// A measured table as a scene holds it: read once, looked up by every renderer.
#pragma once

#include "core/measured/table_lookup.h"
#include "core/reflectance/kernel.h"

#include <memory>
#include <string>

namespace reflectance {

struct MeasuredTable {
    Table table;        ///< in double: the truth
    TableTexels texels; ///< rounded to float, for everything else
};

/// Any file of a measurement that the program reads; what is no grid is brought onto one.
[[nodiscard]] Result<std::shared_ptr<const MeasuredTable>> loadTable(const std::string& path);

/// The table, for renderers; both forms of it are made here.
[[nodiscard]] std::shared_ptr<const MeasuredTable> measuredTable(Table table);

/// For the kernels; the table must outlive what they are handed. Of null it is black.
[[nodiscard]] MeasuredSurfaces lookUpsIn(const MeasuredTable* table);

} // namespace reflectance
