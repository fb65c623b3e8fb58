#include "app/explorer/ui/plot.h"
#include "app/explorer/ui/plot_canvas.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

ImU32 exactly(ChartColor color)
{
    return IM_COL32((color >> 16) & 0xFF, (color >> 8) & 0xFF, color & 0xFF, 255);
}

void hatch(ImDrawList& list, ImVec2 low, ImVec2 high)
{
    list.PushClipRect(low, high, true);
    const float spacing = points(7);
    const float height = high.y - low.y;
    for (float at = std::floor((low.x + low.y) / spacing) * spacing; at < high.x + high.y; at += spacing)
        list.AddLine({at - low.y, low.y}, {at - low.y - height, high.y}, palette::hovered);
    list.PopClipRect();
}

void drawCells(ImDrawList& list, const HeatMap& map, ImVec2 low, ImVec2 high)
{
    const float width = (high.x - low.x) / static_cast<float>(map.columns);
    const float height = (high.y - low.y) / static_cast<float>(map.rows);
    hatch(list, low, high); // what no cell covers is a hole
    for (std::size_t row = 0; row < map.rows; ++row)
        for (std::size_t column = 0; column < map.columns; ++column) {
            const double value = map.at(column, row);
            if (std::isnan(value))
                continue;
            const ImVec2 corner{low.x + width * static_cast<float>(column),
                                high.y - height * static_cast<float>(row + 1)};
            list.AddRectFilled(corner, {std::ceil(corner.x + width), std::ceil(corner.y + height)},
                               exactly(colorOf(map, value)));
        }
}

void drawScale(ImDrawList& list, const HeatMap& map, float left, float top, float bottom)
{
    constexpr int steps = 48;
    const float step = (bottom - top) / steps;
    for (int k = 0; k < steps; ++k)
        list.AddRectFilled({left, bottom - step * static_cast<float>(k + 1)},
                           {left + points(12), std::ceil(bottom - step * static_cast<float>(k))},
                           exactly(colorOf(map, valueAlong(map.scale, (k + 0.5) / steps))));
    for (const Tick& tick : ticksOf(map.scale, static_cast<int>((bottom - top) / points(26))))
        plotText(list, left + points(17),
                 bottom - (bottom - top) * static_cast<float>(shareAlong(map.scale, tick.value)), TextAnchor::Left,
                 tick.text);
}

void drawAxes(ImDrawList& list, const HeatMap& map, ImVec2 low, ImVec2 high)
{
    for (const Tick& tick : ticksOf(map.x, static_cast<int>((high.x - low.x) / points(44))))
        plotText(list, low.x + static_cast<float>(shareAlong(map.x, tick.value)) * (high.x - low.x), high.y + points(9),
                 TextAnchor::Centre, tick.text);
    for (const Tick& tick : ticksOf(map.y, static_cast<int>((high.y - low.y) / points(26))))
        plotText(list, low.x - points(5), high.y - static_cast<float>(shareAlong(map.y, tick.value)) * (high.y - low.y),
                 TextAnchor::Right, tick.text);
    plotText(list, (low.x + high.x) / 2, high.y + points(24), TextAnchor::Centre, map.x.label);
    plotText(list, low.x - points(34), low.y - points(12), TextAnchor::Left, map.y.label + ";  " + map.scale.label);
}

void readCell(const HeatMap& map, double x, double y)
{
    std::size_t column = 0;
    std::size_t row = 0;
    if (!cellAt(map, x, y, column, row))
        return;
    const double value = map.at(column, row);
    const auto named = [](const Axis& axis, double at) {
        return axis.label.substr(0, axis.label.find(' ')) + " = " + general(at, 3);
    };
    showReading(named(map.x, x) + ", " + named(map.y, y), {{exactly(std::isnan(value) ? 0x444444 : colorOf(map, value)),
                                                            std::isnan(value) ? "not measured" : general(value, 5)}});
}

} // namespace

PlotHover drawPlot(const char* id, const HeatMap& map, ImVec2 size)
{
    const PlotArea area = plotArea(id, size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low{area.topLeft.x + points(46), area.topLeft.y + points(26)};
    const ImVec2 high{area.topLeft.x + area.size.x - points(74), area.topLeft.y + area.size.y - points(36)};
    if (high.x - low.x < points(40) || high.y - low.y < points(30) || map.columns == 0 || map.rows == 0)
        return {};
    drawCells(list, map, low, high);
    drawAxes(list, map, low, high);
    drawScale(list, map, high.x + points(10), low.y, high.y);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!area.hovered || mouse.x < low.x || mouse.x >= high.x || mouse.y <= low.y || mouse.y > high.y) {
        tooltip(readingHint);
        return {};
    }
    const PlotHover hover{true, valueAlong(map.x, (mouse.x - low.x) / (high.x - low.x)),
                          valueAlong(map.y, (high.y - mouse.y) / (high.y - low.y))};
    list.AddLine({mouse.x, low.y}, {mouse.x, high.y}, palette::text);
    list.AddLine({low.x, mouse.y}, {high.x, mouse.y}, palette::text);
    readCell(map, hover.x, hover.y);
    return hover;
}

} // namespace reflectance::explorer
