// The surface as curves: polar in the plane of incidence, and over the viewing angle, beside other models of the catalogue.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawCurvesPage(ExplorerState& state);

/// The current surface first, then those laid over it, each with the parameters that the scene keeps for it.
[[nodiscard]] std::vector<NamedSurface> shownSurfaces(const ExplorerState& state);

} // namespace reflectance::explorer
