// Over the picture: the values of the probed point where the page is closed, and that a term is seen alone.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

/// At the lower edge of the picture that lies between the corners. Nothing while the page of probes is open.
void drawProbeCard(ExplorerState& state, ImVec2 low, ImVec2 high);

/// Says that a term is seen alone, and gives the whole picture back. Nothing while the whole is seen.
void drawTermBanner(ExplorerState& state, ImVec2 topLeft, float room);

} // namespace reflectance::explorer
