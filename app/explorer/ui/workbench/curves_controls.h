// The controls beside the plots of the page Curves.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// Those that the open plot knows.
void drawCurvesControls(ExplorerState& state);

} // namespace reflectance::explorer
