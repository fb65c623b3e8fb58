// The workbench's page of the sensor: where the picture's difference from the truth comes from.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawSensorPage(ExplorerState& state);

} // namespace reflectance::explorer
