// A model fitted to a measurement: the curve over the data, the parameters with their errors, and one click to apply them.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawFitPage(ExplorerState& state);

/// The scene's surface becomes what was fitted.
void applyFit(const FitOutcome& outcome, Scene& scene);

} // namespace reflectance::explorer
