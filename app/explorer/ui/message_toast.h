// A message over the picture, whole and wrapped, with a button that dismisses it.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

/// Stands on `bottomLeft`, at most `width` pixels wide. Nothing while there is no message.
void drawMessage(ExplorerState& state, ImVec2 bottomLeft, float width);

} // namespace reflectance::explorer
