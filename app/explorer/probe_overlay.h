// What is drawn over the picture of a probed point: N, L, V and R, the lobe, and the pins' markers.
#pragma once

#include "app/explorer/light_handles.h"

namespace reflectance::explorer {

/// Into one pane of the picture; `isB` where that pane shows B.
void drawProbeMarks(ImDrawList& canvas, const ExplorerState& state, const PictureView& view, bool isB);

} // namespace reflectance::explorer
