// The surface as plots, beside B and other models: curves, polar, lobes in space, lit balls, albedo, a wedge of one parameter,
// and a map over both angles.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawCurvesPage(ExplorerState& state);

} // namespace reflectance::explorer
