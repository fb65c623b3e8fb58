#include "app/explorer/ui/stops_legend.h"

#include "app/explorer/ui/widgets.h"
#include "core/sensor/inputs.h"

#include <cmath>
#include <string>

namespace reflectance::explorer {

namespace {

ImU32 inkOf(const std::array<float, 3 * falseColorBands>& colors, std::size_t band)
{
    const auto code = [&](std::size_t c) { return static_cast<int>(std::lround(255.0F * colors[3 * band + c])); };
    return IM_COL32(code(0), code(1), code(2), 255);
}

} // namespace

void drawStopsLegend(ImVec2 bottomLeft)
{
    const float cell = points(24);
    const ImVec2 size{cell * static_cast<float>(falseColorBands) + points(24), points(62)};
    const ImVec2 corner{bottomLeft.x, bottomLeft.y - size.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(palette::floating),
                       points(6));
    const float left = corner.x + points(12);
    drawText(list, Face::Small, {left, corner.y + points(6)}, palette::text, "Luminance in stops from white (0)");
    const float top = corner.y + points(25);
    const auto colors = falseColors();
    for (std::size_t band = 0; band < falseColorBands; ++band) {
        const float x = left + cell * static_cast<float>(band);
        list.AddRectFilled({x, top}, {x + cell, top + points(12)}, inkOf(colors, band));
        if (band == 0)
            continue;
        const int stop = lowestStop + static_cast<int>(band) - 1;
        const std::string text = stop < 0 ? "\u2212" + std::to_string(-stop) : std::to_string(stop);
        drawText(list, Face::Small, {x - sizeIn(Face::Small, text).x / 2, top + points(14)}, palette::quiet, text);
    }
}

} // namespace reflectance::explorer
