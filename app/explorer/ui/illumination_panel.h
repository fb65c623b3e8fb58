// The first stage: the lights and what surrounds the object.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawIlluminationPanel(ExplorerState& state);

} // namespace reflectance::explorer
