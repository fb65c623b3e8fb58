#include "core/chart/lobe_chart.h"
#include "core/chart/svg_writer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

using Anchor = SvgWriter::Anchor;
constexpr double right = std::numbers::pi / 2;

struct Place {
    double x, y, scale;

    [[nodiscard]] double atX(const LobePoint& point) const { return x + scale * point.x; }
    [[nodiscard]] double atY(const LobePoint& point) const { return y - scale * point.y; }
};

/// The surface as a disc with the rings of its rim's height, and the rim over the plane of incidence.
void drawGround(SvgWriter& svg, const LobeChart& chart, const LobeView& view, const Place& place)
{
    constexpr SvgWriter::Stroke grid{.color = 0xD4D4D4};
    for (const Tick& tick : ticksOf({{}, 0.0, chart.largest, AxisScale::Linear}, 4)) {
        std::string ring;
        for (int k = 0; k <= 72; ++k) {
            const LobePoint p = projected(right, k * std::numbers::pi / 36, tick.value / chart.largest, view);
            appendPoint(ring, place.atX(p), place.atY(p), k == 0);
        }
        svg.path(ring, grid);
        const LobePoint label = projected(right, 1.5 * std::numbers::pi, tick.value / chart.largest, view);
        if (tick.value > 0.0)
            svg.text(place.atX(label) + 4, place.atY(label) + 10, tick.text, Anchor::Start, 10);
    }
    std::string arc;
    for (int k = -30; k <= 30; ++k) {
        const LobePoint p = projected(std::abs(k) * std::numbers::pi / 60, k < 0 ? std::numbers::pi : 0.0, 1.0, view);
        appendPoint(arc, place.atX(p), place.atY(p), k == -30);
    }
    svg.path(arc, grid);
}

void drawFacet(SvgWriter& svg, const LobeChart& chart, const LobeFacet& facet, const LobeView& view, const Place& place)
{
    std::string outline;
    for (std::size_t i = 0; i < 4; ++i)
        appendPoint(outline, place.atX(facet.corners[i]), place.atY(facet.corners[i]), i == 0);
    const ChartColor color = chart.lobes[facet.lobe].color;
    if (view.filled)
        svg.area(outline, shadedColor(color, facet.light), {shadedColor(color, facet.light), 0.4});
    else
        svg.path(outline + "Z", {color, 0.5, 0.8});
}

} // namespace

std::string svgOf(const LobeChart& chart, const LobeView& view, int width, int height)
{
    SvgWriter svg(width, height);
    const double legend = 16.0 * static_cast<double>(chart.lobes.size());
    const double room = std::max(80.0, height - 84.0 - legend);
    const Place place{width / 2.0, 44.0 + 0.62 * room, std::max(40.0, std::min(width / 2.0 - 44.0, 0.6 * room))};
    svg.text(16, 22, chart.title, Anchor::Start, 14, 0x101010);
    drawGround(svg, chart, view, place);
    for (const LobeFacet& facet : facetsOf(chart, view))
        drawFacet(svg, chart, facet, view, place);
    for (const LobeChart::Ray& ray : chart.rays) {
        const LobePoint tip = projected(ray.theta, ray.phi, 1.0, view);
        svg.line(place.x, place.y, place.atX(tip), place.atY(tip), {.color = 0x606060, .dashed = true});
        svg.text(place.atX(tip) + 4, place.atY(tip), ray.name, Anchor::Start, 11);
    }
    double y = height - legend - 8;
    svg.text(width - 16.0, 22, chart.radiusLabel, Anchor::End, 11);
    for (const LobeChart::Lobe& lobe : chart.lobes) {
        svg.line(24, y, 42, y, {lobe.color, 2.4});
        svg.text(48, y + 4, lobe.name, Anchor::Start, 11);
        y += 16;
    }
    return svg.finished();
}

} // namespace reflectance
