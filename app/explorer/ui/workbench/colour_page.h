// Where K comes from: filters, primaries and a chart of 24 patches under each cheat, while a slider widens the filters.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawColourPage(ExplorerState& state);

} // namespace reflectance::explorer
