// Undo, redo and the list of steps, in the toolbar.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// Three icons on the current line.
void drawHistoryButtons(ExplorerState& state);
[[nodiscard]] float historyButtonsWidth();

} // namespace reflectance::explorer
