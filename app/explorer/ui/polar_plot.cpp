#include "app/explorer/ui/plot.h"
#include "app/explorer/ui/plot_canvas.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance::explorer {

namespace {

constexpr float halfTurn = std::numbers::pi_v<float>;

struct Disc {
    ImVec2 centre;
    float radius = 0.0F;

    [[nodiscard]] ImVec2 at(double angle, double share) const
    {
        const auto r = static_cast<float>(share) * radius;
        return {centre.x + r * static_cast<float>(std::sin(angle)), centre.y - r * static_cast<float>(std::cos(angle))};
    }
};

void drawRings(ImDrawList& list, const PolarChart& chart, const Disc& disc)
{
    for (const Tick& tick : ticksOf({{}, 0.0, chart.largest}, disc.radius > points(90) ? 5 : 3)) {
        const float r = disc.radius * static_cast<float>(tick.value / chart.largest);
        if (r <= 0.0F)
            continue;
        list.PathArcTo(disc.centre, r, -halfTurn, 0.0F, 64);
        list.PathStroke(palette::raised);
        plotText(list, disc.centre.x + r, disc.centre.y + points(9), TextAnchor::Centre, tick.text);
    }
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        const double angle = degrees * std::numbers::pi / 180.0;
        list.AddLine(disc.centre, disc.at(angle, 1.0), palette::raised);
        if (std::abs(degrees) < 90) {
            const ImVec2 beyond = disc.at(angle, 1.0 + static_cast<double>(points(11) / disc.radius));
            plotText(list, beyond.x, beyond.y, TextAnchor::Centre, std::to_string(std::abs(degrees)) + "\u00B0");
        }
    }
}

void drawRays(ImDrawList& list, const PolarChart& chart, const Disc& disc)
{
    for (std::size_t i = 0; i < chart.rays.size(); ++i) {
        const ImVec2 rim = disc.at(chart.rays[i], 1.0);
        list.AddLine(disc.centre, rim, palette::quiet);
        if (i < chart.rayNames.size()) {
            const ImVec2 label = disc.at(chart.rays[i], 0.9);
            plotText(list, label.x + points(6), label.y, TextAnchor::Left, chart.rayNames[i], palette::text);
        }
    }
}

void drawCurve(ImDrawList& list, const PolarChart& chart, const PolarChart::Curve& curve, const Disc& disc)
{
    std::vector<ImVec2> run;
    const auto flush = [&] {
        if (run.size() > 1)
            list.AddPolyline(run.data(), static_cast<int>(run.size()), onDark(curve.color, curve.faint ? 0.4F : 1.0F),
                             ImDrawFlags_None, points(1.6F));
        run.clear();
    };
    for (std::size_t i = 0; i < std::min(curve.angle.size(), curve.radius.size()); ++i) {
        const double share = curve.radius[i] / chart.largest;
        if (std::isfinite(share))
            run.push_back(disc.at(curve.angle[i], share));
        else
            flush();
    }
    flush();
    for (std::size_t i = 0; i < std::min(curve.angle.size(), curve.spread.size()); ++i) {
        const double low = std::max(0.0, curve.radius[i] - curve.spread[i]) / chart.largest;
        const double high = (curve.radius[i] + curve.spread[i]) / chart.largest;
        if (!std::isfinite(low) || !std::isfinite(high))
            continue;
        list.AddLine(disc.at(curve.angle[i], low), disc.at(curve.angle[i], high), onDark(curve.color));
        list.AddCircleFilled(disc.at(curve.angle[i], curve.radius[i] / chart.largest), points(2.2F),
                             onDark(curve.color), 12);
    }
}

void readCurves(ImDrawList& list, const PolarChart& chart, const Disc& disc, double angle, ImVec2 mouse)
{
    std::vector<PlotEntry> entries;
    std::vector<ImVec2> dots;
    for (const PolarChart::Curve& curve : chart.curves) {
        const double radius = readAt(curve.angle, curve.radius, angle);
        if (!std::isfinite(radius))
            continue;
        entries.push_back({onDark(curve.color), general(radius, 5) + "  " + curve.name});
        dots.push_back(disc.at(angle, radius / chart.largest));
    }
    markReadings(list, entries, dots, mouse);
    showReading("\u03B8_r = " + general(angle * 180.0 / std::numbers::pi, 4) + "\u00B0", entries);
}

void drawNames(ImDrawList& list, const PolarChart& chart, ImVec2 upperRight)
{
    std::vector<PlotEntry> entries;
    for (const PolarChart::Curve& curve : chart.curves)
        entries.push_back({onDark(curve.color, curve.faint ? 0.4F : 1.0F), curve.name});
    drawLegend(list, upperRight, entries);
}

} // namespace

PlotHover drawPlot(const char* id, const PolarChart& chart, ImVec2 size, bool named)
{
    const PlotArea area = plotArea(id, size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    Disc disc;
    disc.radius = std::min(area.size.x / 2 - points(30), area.size.y - points(64));
    disc.centre = {area.topLeft.x + area.size.x / 2, area.topLeft.y + area.size.y - points(38)};
    if (disc.radius < points(24)) {
        tooltip(readingHint);
        return {};
    }
    drawRings(list, chart, disc);
    drawRays(list, chart, disc);
    list.PushClipRect(area.topLeft, {area.topLeft.x + area.size.x, area.topLeft.y + area.size.y}, true);
    for (const PolarChart::Curve& curve : chart.curves)
        drawCurve(list, chart, curve, disc);
    list.PopClipRect();
    if (named)
        drawNames(list, chart, {area.topLeft.x + area.size.x - points(8), area.topLeft.y + points(4)});
    plotText(list, disc.centre.x, disc.centre.y + points(24), TextAnchor::Centre, chart.radiusLabel);

    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float dx = mouse.x - disc.centre.x;
    const float dy = disc.centre.y - mouse.y;
    if (!area.hovered || dy < 0.0F) {
        tooltip(readingHint);
        return {};
    }
    const double angle = std::atan2(static_cast<double>(dx), static_cast<double>(dy));
    list.AddLine(disc.centre, disc.at(angle, 1.0), palette::accent);
    readCurves(list, chart, disc, angle, mouse);
    return {true, angle, chart.largest * static_cast<double>(std::hypot(dx, dy) / disc.radius)};
}

} // namespace reflectance::explorer
