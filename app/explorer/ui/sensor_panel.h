// The third stage: from radiance to the code values that are seen.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawSensorPanel(ExplorerState& state);

} // namespace reflectance::explorer
