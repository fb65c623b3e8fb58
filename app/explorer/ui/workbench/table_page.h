// The measured table in use as a map over theta_i and theta_r, its reciprocity, and a slice under the mouse.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawTablePage(ExplorerState& state);

} // namespace reflectance::explorer
