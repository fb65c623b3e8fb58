// The offer to restore a session that a crash cut off, over the picture until it is taken or dismissed.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

/// Stands on `bottomLeft`. Returns its upper edge; `bottomLeft`'s own where nothing is offered.
float drawSessionOffer(ExplorerState& state, ImVec2 bottomLeft);

} // namespace reflectance::explorer
