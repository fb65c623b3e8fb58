// A trade as a page for people: one file of HTML that needs nothing beside itself.
#pragma once

#include "core/study/trade/trade.h"

#include <string>

namespace reflectance {

/// Chart, findings, what was skipped and why, and every candidate in a table; the machine is stated. `command` makes it anew.
[[nodiscard]] std::string htmlOf(const Trade& trade, const Wanted& wanted, const std::string& command);

/// What the trade says in sentences: the front, what dominates, what a tolerance chooses.
[[nodiscard]] std::vector<std::string> findingsOf(const Trade& trade, const Wanted& wanted);

/// "simd + 1_sample: error 0.01, 2.3 ms +- 0.1; gives up ...".
[[nodiscard]] std::string sentenceOf(const Trade& trade, const Candidate& candidate);

} // namespace reflectance
