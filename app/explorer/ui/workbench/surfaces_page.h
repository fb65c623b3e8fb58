// The library of surfaces as a page: thumbnails under the scene's own lights, a search, and one click to apply.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawSurfacesPage(ExplorerState& state);

} // namespace reflectance::explorer
