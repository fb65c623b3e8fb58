#include "app/explorer/ui/lobe_plot.h"

#include "app/explorer/ui/plot_canvas.h"
#include "core/base/text.h"
#include "core/math/angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance::explorer {

namespace {

constexpr double right = std::numbers::pi / 2;

struct Place {
    ImVec2 centre;
    float scale = 1.0F;

    [[nodiscard]] ImVec2 at(const LobePoint& point) const
    {
        return {centre.x + scale * static_cast<float>(point.x), centre.y - scale * static_cast<float>(point.y)};
    }
};

void drawGround(ImDrawList& list, const LobeChart& chart, const LobeView& view, const Place& place)
{
    for (const Tick& tick : ticksOf({{}, 0.0, chart.largest}, place.scale > points(90) ? 5 : 3)) {
        const double share = tick.value / chart.largest;
        for (int k = 0; k < 72; ++k)
            list.PathLineTo(place.at(projected(right, k * std::numbers::pi / 36, share, view)));
        list.PathStroke(palette::hovered, ImDrawFlags_Closed);
        const ImVec2 label = place.at(projected(right, 1.5 * std::numbers::pi, share, view));
        if (tick.value > 0.0)
            plotText(list, label.x + points(3), label.y + points(7), TextAnchor::Left, tick.text);
    }
    for (int k = -36; k <= 36; ++k)
        list.PathLineTo(place.at(projected(std::abs(k) * right / 36, k < 0 ? std::numbers::pi : 0.0, 1.0, view)));
    list.PathStroke(palette::hovered);
}

void drawRays(ImDrawList& list, const LobeChart& chart, const LobeView& view, const Place& place)
{
    for (const LobeChart::Ray& ray : chart.rays) {
        const ImVec2 tip = place.at(projected(ray.theta, ray.phi, 1.0, view));
        list.AddLine(place.centre, tip, palette::quiet);
        plotText(list, tip.x + points(5), tip.y - points(4), TextAnchor::Left, ray.name, palette::text);
    }
}

ChartColor asColor(ImU32 color)
{
    return (color & 0xFFU) << 16 | (color & 0xFF00U) | (color >> 16 & 0xFFU);
}

void drawFacets(ImDrawList& list, const LobeChart& chart, const std::vector<LobeFacet>& facets, const LobeView& view,
                const Place& place)
{
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill; // patches meet: a soft rim would show as a seam
    for (const LobeFacet& facet : facets) {
        ImVec2 at[4];
        for (std::size_t i = 0; i < 4; ++i)
            at[i] = place.at(facet.corners[i]);
        const ImU32 color = onDark(chart.lobes[facet.lobe].color, view.filled ? 1.0F : 0.75F);
        if (view.filled) {
            const ChartColor shaded = shadedColor(asColor(color), facet.light);
            list.AddQuadFilled(at[0], at[1], at[2], at[3],
                               IM_COL32(shaded >> 16 & 0xFF, shaded >> 8 & 0xFF, shaded & 0xFF, 255));
        } else {
            if (facet.ring % 2 == 0)
                list.AddLine(at[0], at[1], color);
            if (facet.column % 2 == 0)
                list.AddLine(at[0], at[3], color);
        }
    }
    list.Flags = flags;
}

/// The grid's own direction next to the place: what is read there is the core's number, not one between two.
std::size_t nearestCorner(const LobeFacet& facet, double x, double y)
{
    const auto apart = [&](const LobePoint& p) { return std::hypot(p.x - x, p.y - y); };
    const auto nearer = [&](const LobePoint& a, const LobePoint& b) { return apart(a) < apart(b); };
    return static_cast<std::size_t>(std::min_element(facet.corners.begin(), facet.corners.end(), nearer) -
                                    facet.corners.begin());
}

PlotHover readFacet(const LobeChart& chart, const LobeFacet& facet, double x, double y)
{
    const std::size_t corner = nearestCorner(facet, x, y);
    const std::size_t ring = facet.ring + (corner >= 2 ? 1 : 0);
    const std::size_t column = facet.column + (corner == 1 || corner == 2 ? 1 : 0);
    std::vector<PlotEntry> entries;
    for (const LobeChart::Lobe& lobe : chart.lobes)
        entries.push_back({onDark(lobe.color), general(lobe.radius[chart.at(ring, column)], 5) + "  " + lobe.name});
    showReading("\u03B8_r = " + general(degrees(chart.theta[ring]), 4) +
                    "\u00B0, \u03C6 = " + general(degrees(chart.phi[column]), 4) + "\u00B0",
                entries);
    return {true, chart.theta[ring], chart.phi[column]};
}

std::vector<PlotEntry> legendOf(const LobeChart& chart)
{
    std::vector<PlotEntry> entries;
    for (const LobeChart::Lobe& lobe : chart.lobes)
        entries.push_back({onDark(lobe.color), lobe.name});
    return entries;
}

} // namespace

PlotHover drawLobes(const char* id, const LobeChart& chart, LobeView& view, ImVec2 size)
{
    const PlotArea area = plotArea(id, size);
    if (ImGui::IsItemActive()) {
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        view.azimuth -= static_cast<double>(moved.x / points(140));
        view.elevation = std::clamp(view.elevation + static_cast<double>(moved.y / points(140)), -right, right);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Place place{{area.topLeft.x + area.size.x / 2, area.topLeft.y + 0.62F * area.size.y},
                      std::min(area.size.x / 2 - points(30), 0.56F * area.size.y)};
    if (place.scale < points(24)) {
        tooltip(readingHint);
        return {};
    }
    list.PushClipRect(area.topLeft, {area.topLeft.x + area.size.x, area.topLeft.y + area.size.y}, true);
    drawGround(list, chart, view, place);
    const std::vector<LobeFacet> facets = facetsOf(chart, view);
    drawFacets(list, chart, facets, view, place);
    drawRays(list, chart, view, place);
    list.PopClipRect();
    drawLegend(list, {area.topLeft.x + area.size.x - points(8), area.topLeft.y}, legendOf(chart));
    plotText(list, area.topLeft.x + points(8), area.topLeft.y + area.size.y - points(10), TextAnchor::Left,
             chart.radiusLabel);

    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const double x = static_cast<double>((mouse.x - place.centre.x) / place.scale);
    const double y = static_cast<double>((place.centre.y - mouse.y) / place.scale);
    const LobeFacet* facet = area.hovered && !ImGui::IsItemActive() ? facetAt(facets, x, y) : nullptr;
    if (!facet) {
        tooltip("Drag to turn the lobes; move the mouse over them to read their values.");
        return {};
    }
    return readFacet(chart, *facet, x, y);
}

} // namespace reflectance::explorer
