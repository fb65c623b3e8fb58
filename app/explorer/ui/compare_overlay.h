// What lies over the picture while two variants are compared: how they are shown, what separates them, their names, the
// divider, the scale of the map.
#pragma once

#include "app/explorer/layout.h"
#include "app/explorer/state.h"

namespace reflectance::explorer {

/// Over the picture's area, inside its window. `panes` are where A and B stand.
void drawCompareOverlay(ExplorerState& state, const Area& area, const Panes& panes);

/// Of the bar with the ways of showing and the figures, which stands in the middle of the picture's upper edge.
[[nodiscard]] float compareBarHeight();
[[nodiscard]] float compareBarWidth(float pictureWidth);

} // namespace reflectance::explorer
