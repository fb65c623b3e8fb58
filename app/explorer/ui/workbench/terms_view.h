// The terms of the picture: each alone, and what each buys and costs.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// Buttons that show a term of the formula, or one light, alone.
void drawTermChoices(ExplorerState& state);

/// Bars of what each term buys and costs, and the button that measures them.
void drawTermBars(ExplorerState& state);

} // namespace reflectance::explorer
