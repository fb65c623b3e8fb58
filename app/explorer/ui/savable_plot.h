// A plot under a line that names it and holds the one menu by which every plot is saved: SVG, PNG, CSV.
#pragma once

#include "app/explorer/state.h"
#include "app/explorer/ui/plot.h"

#include <functional>
#include <string>

namespace reflectance::explorer {

/// How a plot is saved; called when the menu asks for it.
struct PlotFiles {
    std::string name; ///< of the files, without ending: "curves"
    std::string title;
    std::function<std::string()> svg, csv;
};

[[nodiscard]] float plotHeadingHeight();

/// Draws the line, `size.x` wide, and leaves the cursor below it. `size` is that of line and plot together: what a PNG holds.
void plotHeading(const PlotFiles& files, ImVec2 size, ExplorerState& state);

/// Line and plot together take `size` pixels at the cursor. `id` is unique in the page and names the files; `more` is what else
/// drawPlot takes for this kind of chart.
template <class Value, class... More>
PlotHover savablePlot(const char* id, const Value& chart, ImVec2 size, ExplorerState& state, More... more)
{
    ImGui::BeginGroup();
    plotHeading({id, chart.title, [&] { return svgOf(chart, 900, 480); }, [&] { return csvOf(chart); }}, size, state);
    const PlotHover hover = drawPlot(id, chart, {size.x, size.y - plotHeadingHeight()}, more...);
    ImGui::EndGroup();
    return hover;
}

} // namespace reflectance::explorer
