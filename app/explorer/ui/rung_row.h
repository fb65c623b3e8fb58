// How the surface in hand is drawn: its rungs, from the list that Trade measures.
#pragma once

#include "app/explorer/state.h"

#include <string>

namespace reflectance::explorer {

/// Part of the Surface card: a menu of all rungs by what they trade. Taking one gives up those that exclude it.
void rungRow(ExplorerState& state);

/// "double + k_diagonal"; empty for a surface without rungs.
[[nodiscard]] std::string rungsText(const Surface& surface);

} // namespace reflectance::explorer
