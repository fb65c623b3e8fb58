// Interpolation in a table, one angle after the other, in which holes take no part. Internal to the table.
#pragma once

#include "core/measured/table.h"

namespace reflectance {

/// Between the samples `below` and `below + 1`, at the share t of the way; t = 0 needs no sample above.
struct Place {
    std::size_t below = 0;
    double t = 0.0;
};
using Places = std::array<Place, 3>;

/// Where an angle stands among ascending samples; angles beyond the ends count as the ends.
[[nodiscard]] Place placeIn(const std::vector<double>& samples, double angle);

/// Numbers, and how much of the weight they come from was measured (0 .. 1).
struct Share {
    Channels values{};
    double weight = 0.0;
};

[[nodiscard]] Share interpolated(const Table& table, const Places& places);

} // namespace reflectance
