#include "app/explorer/ui/plot.h"
#include "app/explorer/ui/plot_canvas.h"
#include "core/base/text.h"
#include "core/chart/labels.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

/// The inner rectangle of a plot, and places in it.
struct Field {
    ImVec2 low, high; ///< upper left, lower right
    const Chart& chart;

    [[nodiscard]] float x(double value) const
    {
        return low.x + static_cast<float>(shareAlong(chart.x, value)) * (high.x - low.x);
    }
    [[nodiscard]] float y(double value) const
    {
        return high.y - static_cast<float>(shareAlong(chart.y, value)) * (high.y - low.y);
    }
};

/// What of an axis's label there is room for: first what follows the semicolon goes.
std::string labelWithin(const std::string& label, float width)
{
    const std::size_t clause = label.find(';');
    ImGui::PushFont(face(Face::Small));
    std::string shown = sizeIn(Face::Small, label).x > width && clause != std::string::npos
                            ? elided(label.substr(0, clause) + ")", width)
                            : elided(label, width);
    ImGui::PopFont();
    return shown;
}

void drawAxes(ImDrawList& list, const Field& field)
{
    const Chart& chart = field.chart;
    for (const Tick& tick : ticksOf(chart.x, static_cast<int>((field.high.x - field.low.x) / points(56)))) {
        const float x = std::round(field.x(tick.value));
        list.AddLine({x, field.low.y}, {x, field.high.y}, palette::raised);
        plotText(list, x, field.high.y + points(9), TextAnchor::Centre, tick.text);
    }
    for (const Tick& tick : ticksOf(chart.y, static_cast<int>((field.high.y - field.low.y) / points(26)))) {
        const float y = std::round(field.y(tick.value));
        list.AddLine({field.low.x, y}, {field.high.x, y}, palette::raised);
        plotText(list, field.low.x - points(5), y, TextAnchor::Right, tick.text);
    }
    plotText(list, (field.low.x + field.high.x) / 2, field.high.y + points(24), TextAnchor::Centre,
             labelWithin(chart.x.label, field.high.x - field.low.x + points(46)));
    plotText(list, field.low.x - points(34), field.low.y - points(12), TextAnchor::Left, chart.y.label);
}

void drawSeries(ImDrawList& list, const Series& series, const Field& field)
{
    const ImU32 color = onDark(series.color, series.faint ? 0.4F : 1.0F);
    std::vector<ImVec2> run;
    const auto flush = [&] {
        if (run.size() > 1 && series.mark != Mark::Dots)
            list.AddPolyline(run.data(), static_cast<int>(run.size()), color, ImDrawFlags_None, points(1.6F));
        run.clear();
    };
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        const ImVec2 at{field.x(series.x[i]), field.y(series.y[i])};
        if (!std::isfinite(at.x) || !std::isfinite(at.y)) {
            flush();
            continue;
        }
        run.push_back(at);
        if (i < series.spread.size())
            list.AddLine({at.x, field.y(series.y[i] - series.spread[i])},
                         {at.x, field.y(series.y[i] + series.spread[i])}, color);
        if (i < series.spreadX.size()) {
            const double low = std::max(series.x[i] - series.spreadX[i],
                                        field.chart.x.scale == AxisScale::Log ? field.chart.x.low : -HUGE_VAL);
            list.AddLine({field.x(low), at.y}, {field.x(series.x[i] + series.spreadX[i]), at.y}, color);
        }
        if (series.mark != Mark::Line)
            list.AddCircleFilled(at, points(3.2F), color);
    }
    flush();
}

/// The names of all points at once, so that none lies on another.
void drawLabels(ImDrawList& list, const Field& field)
{
    std::vector<LabelWish> wishes;
    std::vector<std::pair<std::string_view, ImU32>> texts;
    const double unit = points(1); // names are placed at the interface's scale 1
    for (const Series& series : field.chart.series)
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
            const ImVec2 at{field.x(series.x[i]), field.y(series.y[i])};
            const std::string_view text = i < series.labels.size() ? series.labels[i] : std::string_view();
            if (!std::isfinite(at.x) || !std::isfinite(at.y) || series.mark == Mark::Line)
                continue;
            const ImVec2 size = text.empty() ? ImVec2() : sizeIn(Face::Small, text);
            wishes.push_back({at.x / unit, at.y / unit, size.x / unit, size.y / unit});
            texts.emplace_back(text, series.faint ? palette::quiet : palette::text);
        }
    const auto labels =
        placedLabels(wishes, {field.low.x / unit, field.low.y / unit, field.high.x / unit, field.high.y / unit});
    const auto place = [unit](double x, double y) {
        return ImVec2(static_cast<float>(x * unit), static_cast<float>(y * unit));
    };
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (texts[i].first.empty())
            continue;
        const Box& box = labels[i].box;
        if (labels[i].far) {
            const LabelEnd end = endTowards(box, wishes[i].x, wishes[i].y);
            list.AddLine(place(wishes[i].x, wishes[i].y), place(end.x, end.y), palette::quiet);
        }
        drawText(list, Face::Small, place(box.left, box.top), texts[i].second, texts[i].first);
    }
}

void drawGuides(ImDrawList& list, const Field& field)
{
    for (const Guide& guide : field.chart.guides)
        if (guide.vertical) {
            const float x = std::round(field.x(guide.at));
            list.AddLine({x, field.low.y}, {x, field.high.y}, palette::quiet);
            plotText(list, x + points(4), field.low.y + points(8), TextAnchor::Left, guide.label, palette::text);
        } else {
            const float y = std::round(field.y(guide.at));
            list.AddLine({field.low.x, y}, {field.high.x, y}, palette::quiet);
            // At the top there is no room above the line, and the legend stands at its right end.
            const bool high = y - field.low.y < points(18);
            plotText(list, high ? field.low.x + points(6) : field.high.x - points(4), y + points(high ? 9.0F : -8.0F),
                     high ? TextAnchor::Left : TextAnchor::Right, guide.label, palette::text);
        }
}

std::vector<PlotEntry> legendOf(const Chart& chart)
{
    std::vector<PlotEntry> entries;
    for (const Series& series : chart.series)
        if (!series.name.empty())
            entries.push_back({onDark(series.color, series.faint ? 0.4F : 1.0F), series.name});
    return entries;
}

/// A dot on every curve at the mouse's x, a ring about the one that is nearest; their values float beside the mouse.
void readSeries(ImDrawList& list, const Field& field, double x, float mouseY)
{
    const Chart& chart = field.chart;
    std::vector<PlotEntry> entries;
    std::vector<ImVec2> dots;
    for (const Series& series : chart.series) {
        const double value = series.mark == Mark::Dots ? std::nan("") : readAt(series.x, series.y, x);
        if (!std::isfinite(value))
            continue;
        const double spread = readAt(series.x, series.spread, x);
        entries.push_back(
            {onDark(series.color),
             general(value, 5) + (std::isfinite(spread) ? " \u00B1 " + general(spread, 2) : "") + "  " + series.name});
        dots.emplace_back(field.x(x), field.y(value));
    }
    markReadings(list, entries, dots, {field.x(x), mouseY});
    showReading(chart.x.label.substr(0, chart.x.label.find(' ')) + " = " + general(x, 4), entries);
}

} // namespace

PlotHover drawPlot(const char* id, const Chart& chart, ImVec2 size)
{
    const PlotArea area = plotArea(id, size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Field field{{area.topLeft.x + points(46), area.topLeft.y + points(26)},
                      {area.topLeft.x + area.size.x - points(14), area.topLeft.y + area.size.y - points(36)},
                      chart};
    if (field.high.x - field.low.x < points(40) || field.high.y - field.low.y < points(30))
        return {};
    drawAxes(list, field);
    list.PushClipRect(field.low, field.high, true);
    for (const bool faint : {true, false})
        for (const Series& series : chart.series)
            if (series.faint == faint)
                drawSeries(list, series, field);
    drawLabels(list, field);
    drawGuides(list, field);
    list.PopClipRect();
    drawLegend(list, {field.high.x - points(6), field.low.y}, legendOf(chart));

    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool inside = area.hovered && mouse.x >= field.low.x && mouse.x <= field.high.x && mouse.y >= field.low.y &&
                        mouse.y <= field.high.y;
    if (!inside) {
        tooltip(readingHint);
        return {};
    }
    const PlotHover hover{true, valueAlong(chart.x, (mouse.x - field.low.x) / (field.high.x - field.low.x)),
                          valueAlong(chart.y, (field.high.y - mouse.y) / (field.high.y - field.low.y))};
    list.AddLine({mouse.x, field.low.y}, {mouse.x, field.high.y}, palette::accent);
    readSeries(list, field, hover.x, mouse.y);
    return hover;
}

} // namespace reflectance::explorer
