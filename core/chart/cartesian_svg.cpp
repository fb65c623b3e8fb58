#include "core/chart/labels.h"
#include "core/chart/svg_writer.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

using Anchor = SvgWriter::Anchor;
constexpr SvgWriter::Stroke grid{.color = 0xE2E2E2};
constexpr SvgWriter::Stroke frame{.color = 0x808080};

/// The inner rectangle, in pixels.
struct Field {
    double left, top, right, bottom;

    [[nodiscard]] double x(const Axis& axis, double value) const
    {
        return left + shareAlong(axis, value) * (right - left);
    }
    [[nodiscard]] double y(const Axis& axis, double value) const
    {
        return bottom - shareAlong(axis, value) * (bottom - top);
    }
};

constexpr int legendSize = 11, labelSize = 10;
/// Left of a legend's names, with their marks; and right of them.
constexpr double legendIndent = 38.0, margin = 20.0;

/// What the names of the series take to the right of the field, marks and margin included; longer names than two fifths of
/// the picture go into several lines.
double legendWidth(const Chart& chart, int width)
{
    double widest = 0.0;
    for (const Series& series : chart.series)
        widest = std::max(widest, textWidth(series.name, legendSize));
    return widest > 0.0 ? std::clamp(widest + legendIndent + 4.0, 176.0, std::max(176.0, 0.4 * width)) : margin;
}

/// Where an error bar ends that would leave a logarithmic axis.
double smallestOn(const Axis& axis)
{
    return axis.scale == AxisScale::Log ? axis.low : -HUGE_VAL;
}

void drawAxes(SvgWriter& svg, const Chart& chart, const Field& field)
{
    for (const Tick& tick : ticksOf(chart.x, static_cast<int>((field.right - field.left) / 70.0))) {
        const double x = field.x(chart.x, tick.value);
        svg.line(x, field.top, x, field.bottom, grid);
        svg.text(x, field.bottom + 16, tick.text, Anchor::Middle, 11);
    }
    for (const Tick& tick : ticksOf(chart.y, static_cast<int>((field.bottom - field.top) / 40.0))) {
        const double y = field.y(chart.y, tick.value);
        svg.line(field.left, y, field.right, y, grid);
        svg.text(field.left - 6, y + 4, tick.text, Anchor::End, 11);
    }
    svg.line(field.left, field.top, field.left, field.bottom, frame);
    svg.line(field.left, field.bottom, field.right, field.bottom, frame);
    svg.text((field.left + field.right) / 2, field.bottom + 34, chart.x.label, Anchor::Middle);
    svg.text(14, (field.top + field.bottom) / 2, chart.y.label, Anchor::Middle, 12, 0x303030, -90);
    svg.text(field.left, field.top - 10, chart.title, Anchor::Start, 14, 0x101010);
}

void drawSeries(SvgWriter& svg, const Chart& chart, const Series& series, const Field& field)
{
    const double opacity = series.faint ? 0.35 : 1.0;
    std::string commands;
    bool drawing = false;
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        const double x = field.x(chart.x, series.x[i]);
        const double y = field.y(chart.y, series.y[i]);
        if (!std::isfinite(x) || !std::isfinite(y)) {
            drawing = false;
            continue;
        }
        appendPoint(commands, x, y, !drawing);
        drawing = true;
        if (i < series.spread.size())
            svg.line(x, field.y(chart.y, series.y[i] - series.spread[i]), x,
                     field.y(chart.y, series.y[i] + series.spread[i]), {series.color, 1.0, opacity});
        if (i < series.spreadX.size())
            svg.line(field.x(chart.x, std::max(series.x[i] - series.spreadX[i], smallestOn(chart.x))), y,
                     field.x(chart.x, series.x[i] + series.spreadX[i]), y, {series.color, 1.0, opacity});
        if (series.mark != Mark::Line)
            svg.dot(x, y, 3.2, series.color, opacity);
    }
    if (series.mark != Mark::Dots)
        svg.path(commands, {series.color, 1.8, opacity, series.dashed});
}

/// The names of all points at once, so that none lies on another.
void drawLabels(SvgWriter& svg, const Chart& chart, const Field& field)
{
    std::vector<LabelWish> wishes;
    std::vector<std::pair<std::string_view, ChartColor>> texts;
    for (const Series& series : chart.series)
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
            const LabelWish at{field.x(chart.x, series.x[i]), field.y(chart.y, series.y[i])};
            const std::string_view text = i < series.labels.size() ? series.labels[i] : std::string_view();
            if (!std::isfinite(at.x) || !std::isfinite(at.y) || series.mark == Mark::Line)
                continue;
            wishes.push_back({at.x, at.y, textWidth(text, labelSize), text.empty() ? 0.0 : labelSize + 2.0});
            texts.emplace_back(text, series.faint ? 0x909090 : 0x303030);
        }
    const std::vector<PlacedLabel> labels =
        placedLabels(wishes, {field.left + 2.0, field.top, field.right, field.bottom - 2.0});
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (texts[i].first.empty())
            continue;
        const Box& box = labels[i].box;
        if (labels[i].far) {
            const LabelEnd end = endTowards(box, wishes[i].x, wishes[i].y);
            svg.line(wishes[i].x, wishes[i].y, end.x, end.y, {.color = 0xB0B0B0, .width = 0.8});
        }
        svg.text(box.left, box.bottom - 3.0, texts[i].first, Anchor::Start, labelSize, texts[i].second);
    }
}

void drawGuides(SvgWriter& svg, const Chart& chart, const Field& field)
{
    constexpr SvgWriter::Stroke dashed{.color = 0x606060, .dashed = true};
    for (const Guide& guide : chart.guides)
        if (guide.vertical) {
            const double x = field.x(chart.x, guide.at);
            svg.line(x, field.top, x, field.bottom, dashed);
            svg.text(x + 4, field.top + 12, guide.label, Anchor::Start, 10);
        } else {
            const double y = field.y(chart.y, guide.at);
            svg.line(field.left, y, field.right, y, dashed);
            svg.text(field.right - 4, y - 4, guide.label, Anchor::End, 10);
        }
}

void drawLegend(SvgWriter& svg, const Chart& chart, const Field& field, double width)
{
    double y = field.top + 8;
    for (const Series& series : chart.series) {
        if (series.name.empty())
            continue;
        const double x = field.right + 14;
        if (series.mark == Mark::Dots)
            svg.dot(x + 9, y, 3.2, series.color, series.faint ? 0.35 : 1.0);
        else
            svg.line(x, y, x + 18, y, {series.color, 1.8, series.faint ? 0.35 : 1.0, series.dashed});
        for (const std::string_view line : textLines(series.name, legendSize, width - legendIndent)) {
            svg.text(x + 24, y + 4, line, Anchor::Start, legendSize);
            y += 14;
        }
        y += 4;
    }
}

} // namespace

std::string svgOf(const Chart& chart, int width, int height)
{
    SvgWriter svg(width, height);
    const double legend = legendWidth(chart, width);
    const Field field{64.0, 34.0, std::max(120.0, width - legend), std::max(80.0, height - 46.0)};
    drawAxes(svg, chart, field);
    svg.clipTo(field.left, field.top, field.right - field.left, field.bottom - field.top);
    for (const bool faint : {true, false})
        for (const Series& series : chart.series)
            if (series.faint == faint)
                drawSeries(svg, chart, series, field);
    drawLabels(svg, chart, field);
    drawGuides(svg, chart, field);
    svg.endClip();
    drawLegend(svg, chart, field, legend);
    return svg.finished();
}

} // namespace reflectance
