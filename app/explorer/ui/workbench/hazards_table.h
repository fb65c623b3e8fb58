// The hazards as a table: rows can be sorted, sifted and clicked to see the case.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// The findings that the table shows, in its order: by a column (-1: as they were tried), failures alone if asked.
[[nodiscard]] std::vector<std::size_t> shownFindings(const std::vector<Finding>& findings, bool onlyFailures,
                                                     int column, bool descending);

void drawHazardsTable(ExplorerState& state);

} // namespace reflectance::explorer
