// The hazards H01 to H74 as a page: what was put in, what must come out, what came out on this machine.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawExtremesPage(ExplorerState& state);

} // namespace reflectance::explorer
