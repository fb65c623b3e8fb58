// Changes of a table's shape that change none of its numbers.
#pragma once

#include "core/measured/table.h"

namespace reflectance {

/// The table with its axes in another order: new axis i was axis order[i].
[[nodiscard]] Table reordered(const Table& table, const std::vector<std::size_t>& order);

/// A table whose azimuths begin at 0 and stop one step before the full turn gets that turn, which repeats azimuth 0.
[[nodiscard]] Table closedAround(Table table);

} // namespace reflectance
