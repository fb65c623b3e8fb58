// One point of the picture, stage by stage with its numbers, and the picture's terms alone.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawProbePage(ExplorerState& state);

} // namespace reflectance::explorer
