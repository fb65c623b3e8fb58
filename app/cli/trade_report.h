// A trade in words on the terminal, and as JSON.
#pragma once

#include "core/study/trade/trade.h"

#include <nlohmann/json_fwd.hpp>

namespace reflectance::cli {

/// The front as a table, then findings and what was skipped.
void print(const Trade& trade, const Wanted& wanted);

[[nodiscard]] nlohmann::ordered_json described(const Candidate& candidate);
[[nodiscard]] nlohmann::ordered_json described(const Trade& trade, const Wanted& wanted);

} // namespace reflectance::cli
