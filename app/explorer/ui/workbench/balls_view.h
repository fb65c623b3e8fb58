// Draws a strip of lit balls with their names, and reads what lies under the mouse.
#pragma once

#include "app/explorer/state.h"

#include <imgui.h>

namespace reflectance::explorer {

/// `texture`: the strip as the window holds it; 0 draws frames alone.
void drawBalls(const char* id, const PlotAnswer& answer, unsigned texture, ImVec2 size, ExplorerState& state);

/// What leaves a ball's point towards the viewer under these lights: the factor times the light, in double.
[[nodiscard]] Vec3d radianceOf(const NamedSurface& surface, const std::vector<BallLight>& lights, const Vec3d& N);

} // namespace reflectance::explorer
