// The parts of the sensor: a switch for each, and its fields while it is on.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// All parts but the exposure, in the order in which light passes.
void drawSensorParts(ExplorerState& state);

/// "noise, 10 bit": what differs from the default; empty where nothing does.
[[nodiscard]] std::string sensorPartsSummary(const Sensor& sensor);

} // namespace reflectance::explorer
