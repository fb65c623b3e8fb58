// The second stage: which reflectance model, and its parameters.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawSurfacePanel(ExplorerState& state);

} // namespace reflectance::explorer
