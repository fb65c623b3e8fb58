// The views of the colour page: spectra, the K that results, and the chart of 24 patches.
#pragma once

#include "app/explorer/state.h"
#include "core/chart/chart.h"

#include <imgui.h>

namespace reflectance::explorer {

/// Filters as lines, primaries dashed, each scaled to its largest; the patch's reflectance as it is.
[[nodiscard]] Chart spectraChart(const ColorAnswer& answer, std::size_t patch);

/// K of the chosen patch in the chosen convention, W's condition, and what the chosen cheat costs.
void drawDerivedMatrix(const ColourPage& page, ImVec2 size);

/// Every patch, its upper half in truth, its lower half by the chosen cheat. A click chooses the patch.
void drawPatches(ColourPage& page, ImVec2 size);

/// The chosen patch and its metameric twin, side by side under the primaries' white and under the light chosen.
void drawPair(const ColourPage& page, ImVec2 size);

} // namespace reflectance::explorer
