// Draws lobes in space; a drag turns them.
#pragma once

#include "app/explorer/ui/plot.h"
#include "core/chart/lobe_chart.h"

namespace reflectance::explorer {

/// Takes `size` pixels at the cursor. The reading gives every lobe in the direction under the mouse. In the hover x is theta
/// and y phi of that direction, in radians.
PlotHover drawLobes(const char* id, const LobeChart& chart, LobeView& view, ImVec2 size);

} // namespace reflectance::explorer
