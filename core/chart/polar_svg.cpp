#include "core/chart/svg_writer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

using Anchor = SvgWriter::Anchor;
constexpr double right = std::numbers::pi / 2;

/// Centre and radius of the rim, in pixels.
struct Disc {
    double x, y, radius;

    [[nodiscard]] double atX(double angle, double share) const { return x + share * radius * std::sin(angle); }
    [[nodiscard]] double atY(double angle, double share) const { return y - share * radius * std::cos(angle); }
};

void drawRings(SvgWriter& svg, const PolarChart& chart, const Disc& disc)
{
    constexpr SvgWriter::Stroke grid{.color = 0xDADADA};
    for (const Tick& tick : ticksOf({{}, 0.0, chart.largest, AxisScale::Linear}, 4)) {
        const double r = disc.radius * tick.value / chart.largest;
        if (r <= 0.0)
            continue;
        std::string ring;
        for (int k = 0; k <= 60; ++k) {
            const double angle = -right + k * std::numbers::pi / 60;
            appendPoint(ring, disc.atX(angle, r / disc.radius), disc.atY(angle, r / disc.radius), k == 0);
        }
        svg.path(ring, grid);
        svg.text(disc.x + r, disc.y + 14, tick.text, Anchor::Middle, 10);
    }
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        const double angle = degrees * std::numbers::pi / 180;
        svg.line(disc.x, disc.y, disc.atX(angle, 1.0), disc.atY(angle, 1.0), grid);
        svg.text(disc.atX(angle, 1.07), disc.atY(angle, 1.05) + 4, std::to_string(std::abs(degrees)) + "\u00B0",
                 Anchor::Middle, 10);
    }
}

void drawCurve(SvgWriter& svg, const PolarChart& chart, const PolarChart::Curve& curve, const Disc& disc)
{
    std::string commands;
    bool drawing = false;
    for (std::size_t i = 0; i < std::min(curve.angle.size(), curve.radius.size()); ++i) {
        const double share = curve.radius[i] / chart.largest;
        if (!std::isfinite(share)) {
            drawing = false;
            continue;
        }
        appendPoint(commands, disc.atX(curve.angle[i], share), disc.atY(curve.angle[i], share), !drawing);
        drawing = true;
    }
    svg.path(commands, {curve.color, 1.8, curve.faint ? 0.35 : 1.0});
    for (std::size_t i = 0; i < std::min(curve.angle.size(), curve.spread.size()); ++i) {
        const double low = std::max(0.0, curve.radius[i] - curve.spread[i]) / chart.largest;
        const double high = (curve.radius[i] + curve.spread[i]) / chart.largest;
        if (std::isfinite(low) && std::isfinite(high))
            svg.line(disc.atX(curve.angle[i], low), disc.atY(curve.angle[i], low), disc.atX(curve.angle[i], high),
                     disc.atY(curve.angle[i], high), {.color = curve.color});
    }
}

} // namespace

std::string svgOf(const PolarChart& chart, int width, int height)
{
    SvgWriter svg(width, height);
    const double legend = 16.0 * static_cast<double>(chart.curves.size());
    const double radius = std::max(40.0, std::min(width / 2.0 - 44.0, height - 84.0 - legend));
    const Disc disc{width / 2.0, 50.0 + radius, radius};
    svg.text(16, 22, chart.title, Anchor::Start, 14, 0x101010);
    drawRings(svg, chart, disc);
    svg.text(disc.x, disc.y + 28, chart.radiusLabel, Anchor::Middle, 11);
    for (std::size_t i = 0; i < chart.rays.size(); ++i) {
        svg.line(disc.x, disc.y, disc.atX(chart.rays[i], 1.0), disc.atY(chart.rays[i], 1.0),
                 {.color = 0x606060, .dashed = true});
        if (i < chart.rayNames.size())
            svg.text(disc.atX(chart.rays[i], 0.93) + 5, disc.atY(chart.rays[i], 0.93), chart.rayNames[i], Anchor::Start,
                     11);
    }
    double y = disc.y + 46;
    for (const PolarChart::Curve& curve : chart.curves) {
        svg.clipTo(disc.x - 1.2 * disc.radius, disc.y - 1.2 * disc.radius, 2.4 * disc.radius, 1.2 * disc.radius + 6);
        drawCurve(svg, chart, curve, disc);
        svg.endClip();
        svg.line(24, y, 42, y, {curve.color, 1.8, curve.faint ? 0.35 : 1.0});
        svg.text(48, y + 4, curve.name, Anchor::Start, 11);
        y += 16;
    }
    return svg.finished();
}

} // namespace reflectance
