// A waterfall as a table on standard output and as figures.
#pragma once

#include "core/image/waterfall.h"

#include <nlohmann/json_fwd.hpp>

namespace reflectance::cli {

void printWaterfall(const Waterfall& waterfall);

[[nodiscard]] nlohmann::ordered_json waterfallReport(const Waterfall& waterfall);

} // namespace reflectance::cli
