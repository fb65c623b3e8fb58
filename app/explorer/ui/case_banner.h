// Says over the picture which hazard's case is shown, where to look, and how to get back.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

/// In the current window, for a picture with `room` below `topLeft`; nothing while the user's own scene is shown. In a low
/// picture it keeps clear of the middle, and the caption is a tooltip.
void drawCaseBanner(ExplorerState& state, ImVec2 topLeft, ImVec2 room);

} // namespace reflectance::explorer
