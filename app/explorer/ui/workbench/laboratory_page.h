// The virtual goniometer: a micro-surface is chosen, traced, and seen as its lobe fills in.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawLaboratoryPage(ExplorerState& state);

} // namespace reflectance::explorer
