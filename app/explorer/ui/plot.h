// Draws a chart's value into a page: axes, curves, legend, and what lies under the mouse.
#pragma once

#include "core/chart/chart.h"
#include "core/chart/heat_map.h"

#include <imgui.h>

namespace reflectance::explorer {

/// What the mouse is on, in the chart's own numbers.
struct PlotHover {
    bool inside = false;
    double x = 0.0, y = 0.0;
};

/// Takes `size` pixels at the cursor. A reading of every series at the mouse's x floats beside it. `id` is unique in the page.
PlotHover drawPlot(const char* id, const Chart& chart, ImVec2 size);

/// x is the angle in radians, y the radius. The reading gives every curve at that angle. `named` writes the curves' names above
/// the disc, where no plot beside it does.
PlotHover drawPlot(const char* id, const PolarChart& chart, ImVec2 size, bool named = false);

/// Holes are hatched; the reading names the cell under the mouse.
PlotHover drawPlot(const char* id, const HeatMap& map, ImVec2 size);

/// The colour of a series on the window's dark ground: lighter where the paper's would be too dark to read.
[[nodiscard]] ImU32 onDark(ChartColor color, float opacity = 1.0F);

/// The value of a polyline at x, between the nearest points on both sides; NaN outside and at gaps.
[[nodiscard]] double readAt(const std::vector<double>& x, const std::vector<double>& y, double at);

} // namespace reflectance::explorer
