// Says over the picture which hazard's case is shown, where to look, and how to get back.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

/// In the current window, at most `width` pixels wide; nothing while the user's own scene is shown.
void drawCaseBanner(ExplorerState& state, ImVec2 topLeft, float width);

} // namespace reflectance::explorer
