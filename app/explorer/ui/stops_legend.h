// The legend of the false colours, in the picture's corner.
#pragma once

#include <imgui.h>

namespace reflectance::explorer {

/// Ends at `bottomLeft`, in the current window.
void drawStopsLegend(ImVec2 bottomLeft);

} // namespace reflectance::explorer
