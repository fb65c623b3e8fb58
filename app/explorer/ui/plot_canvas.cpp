#include "app/explorer/ui/plot_canvas.h"
#include "app/explorer/ui/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance::explorer {

PlotArea plotArea(const char* id, ImVec2 size)
{
    PlotArea area{ImGui::GetCursorScreenPos(), {std::max(1.0F, size.x), std::max(1.0F, size.y)}};
    ImGui::InvisibleButton(id, area.size);
    area.hovered = ImGui::IsItemHovered();
    ImGui::GetWindowDrawList()->AddRectFilled(
        area.topLeft, {area.topLeft.x + area.size.x, area.topLeft.y + area.size.y}, palette::well, points(4));
    return area;
}

void plotText(ImDrawList& list, float x, float y, TextAnchor anchor, std::string_view text, ImU32 color)
{
    const ImVec2 size = sizeIn(Face::Small, text);
    const float left = anchor == TextAnchor::Left ? x : anchor == TextAnchor::Centre ? x - size.x / 2 : x - size.x;
    drawText(list, Face::Small, {left, y - size.y / 2}, color, text);
}

void drawLegend(ImDrawList& list, ImVec2 upperRight, const std::vector<PlotEntry>& entries)
{
    float widest = 0.0F;
    for (const PlotEntry& entry : entries)
        widest = std::max(widest, sizeIn(Face::Small, entry.text).x);
    if (!entries.empty()) // names stay legible over curves
        list.AddRectFilled({upperRight.x - widest - points(26), upperRight.y},
                           {upperRight.x + points(4), upperRight.y + points(16) * static_cast<float>(entries.size())},
                           (palette::well & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 190), points(3));
    float y = upperRight.y + points(8);
    for (const PlotEntry& entry : entries) {
        const float left = upperRight.x - sizeIn(Face::Small, entry.text).x;
        plotText(list, left, y, TextAnchor::Left, entry.text, palette::text);
        list.AddLine({left - points(20), y}, {left - points(6), y}, entry.color, points(2));
        y += points(16);
    }
}

void showReading(const std::string& heading, const std::vector<PlotEntry>& entries)
{
    // Unwrapped: the list is as wide as its longest line, wherever the mouse is.
    ImGui::BeginTooltip();
    ImGui::PushFont(face(Face::Small));
    ImGui::TextUnformatted(heading.c_str());
    for (const PlotEntry& entry : entries) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float size = ImGui::GetTextLineHeight();
        ImGui::GetWindowDrawList()->AddCircleFilled({at.x + size / 2, at.y + size / 2}, points(4), entry.color);
        ImGui::Dummy({size, size});
        ImGui::SameLine();
        ImGui::TextUnformatted(entry.text.c_str());
    }
    ImGui::PopFont();
    ImGui::EndTooltip();
}

void markReadings(ImDrawList& list, std::vector<PlotEntry>& entries, std::vector<ImVec2>& places, ImVec2 mouse)
{
    const auto apart = [mouse](ImVec2 p) { return std::hypot(p.x - mouse.x, p.y - mouse.y); };
    const auto nearest =
        std::min_element(places.begin(), places.end(), [&](ImVec2 a, ImVec2 b) { return apart(a) < apart(b); });
    if (nearest == places.end())
        return;
    const auto index = nearest - places.begin();
    std::rotate(places.begin(), places.begin() + index, places.begin() + index + 1);
    std::rotate(entries.begin(), entries.begin() + index, entries.begin() + index + 1);
    for (std::size_t i = 0; i < places.size(); ++i)
        list.AddCircleFilled(places[i], points(2.6F), entries[i].color, 12);
    list.AddCircle(places.front(), points(5), entries.front().color, 16, points(1.4F));
}

ImU32 onDark(ChartColor color, float opacity)
{
    const auto channel = [color](int shift) { return static_cast<float>((color >> shift) & 0xFFU); };
    float r = channel(16);
    float g = channel(8);
    float b = channel(0);
    // Towards white until it is as bright as quiet text.
    const float luma = 0.299F * r + 0.587F * g + 0.114F * b;
    const float share = std::clamp((135.0F - luma) / (255.0F - luma), 0.0F, 1.0F);
    for (float* c : {&r, &g, &b})
        *c += share * (255.0F - *c);
    return IM_COL32(static_cast<int>(r), static_cast<int>(g), static_cast<int>(b), static_cast<int>(255.0F * opacity));
}

double readAt(const std::vector<double>& x, const std::vector<double>& y, double at)
{
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const std::size_t count = std::min(x.size(), y.size());
    if (count == 0 || !(at >= x.front()) || !(at <= x[count - 1]))
        return nothing;
    const auto above = static_cast<std::size_t>(
        std::lower_bound(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count), at) - x.begin());
    if (above == 0 || x[above] == at)
        return y[above];
    const double share = (at - x[above - 1]) / (x[above] - x[above - 1]);
    return y[above - 1] + share * (y[above] - y[above - 1]);
}

} // namespace reflectance::explorer
