// The measured table of a surface: its file, and what is known about it.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void tableRows(ExplorerState& state);

} // namespace reflectance::explorer
