// A trade as a chart: every candidate, the front, what the program would draw by itself, and a tolerance.
#pragma once

#include "core/chart/chart.h"
#include "core/study/trade/trade.h"

#include <string>

namespace reflectance {

/// Cost to the right, error upwards, both logarithmic; error bars are the spread of the times. Candidates without error stand
/// at the lower edge. `labels`: the front's names beside its dots.
[[nodiscard]] Chart chartOf(const Trade& trade, std::optional<double> tolerance, bool labels);

/// Where a candidate stands in the chart.
struct ChartPoint {
    double cost, error;
};
[[nodiscard]] ChartPoint pointOf(const Trade& trade, const Candidate& candidate);

/// A line per candidate, all figures; numbers read back to the same double.
[[nodiscard]] std::string csvOf(const Trade& trade);

} // namespace reflectance
