#include "core/chart/heat_map.h"

#include "core/base/text.h"
#include "core/chart/color_map.h"
#include "core/chart/svg_writer.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

using Anchor = SvgWriter::Anchor;

/// Runs of one colour along a row become one rectangle: a map of thousands of cells stays a small file.
void drawRow(SvgWriter& svg, const HeatMap& map, std::size_t row, double left, double top, double width, double height)
{
    const auto x = [&](std::size_t column) {
        return left + width * static_cast<double>(column) / static_cast<double>(map.columns);
    };
    for (std::size_t first = 0, next = 0; first < map.columns; first = next) {
        const double value = map.at(first, row);
        const auto same = [&](double other) {
            return std::isnan(value) ? std::isnan(other)
                                     : !std::isnan(other) && colorOf(map, other) == colorOf(map, value);
        };
        for (next = first + 1; next < map.columns && same(map.at(next, row));)
            ++next;
        if (std::isnan(value))
            svg.hatched(x(first), top, x(next) - x(first), height);
        else
            svg.rectangle(x(first), top, x(next) - x(first), height, colorOf(map, value));
    }
}

void drawScale(SvgWriter& svg, const HeatMap& map, double left, double top, double height)
{
    constexpr int steps = 64;
    for (int k = 0; k < steps; ++k)
        svg.rectangle(left, top + height * (steps - 1 - k) / steps, 14, height / steps + 0.5,
                      colorOf(map, valueAlong(map.scale, (k + 0.5) / steps)));
    for (const Tick& tick : ticksOf(map.scale, static_cast<int>(height / 40)))
        svg.text(left + 20, top + height * (1.0 - shareAlong(map.scale, tick.value)) + 4, tick.text, Anchor::Start, 11);
    svg.text(left, top - 10, map.scale.label, Anchor::Start, 11);
}

} // namespace

ChartColor colorOf(const HeatMap& map, double value)
{
    const double share = shareAlong(map.scale, value);
    if (map.diverging)
        return divergingColor(2.0 * share - 1.0);
    return sequentialColor(std::isnan(share) ? 0.0 : share); // on a logarithmic scale, 0 and below are darkest
}

bool cellAt(const HeatMap& map, double x, double y, std::size_t& column, std::size_t& row)
{
    const double u = shareAlong(map.x, x) * static_cast<double>(map.columns);
    const double v = shareAlong(map.y, y) * static_cast<double>(map.rows);
    if (!(u >= 0.0) || !(v >= 0.0) || u >= static_cast<double>(map.columns) || v >= static_cast<double>(map.rows))
        return false;
    column = static_cast<std::size_t>(u);
    row = static_cast<std::size_t>(v);
    return true;
}

std::string svgOf(const HeatMap& map, int width, int height)
{
    SvgWriter svg(width, height);
    const double left = 64;
    const double top = 36;
    const double fieldWidth = std::max(80.0, width - left - 110.0);
    const double fieldHeight = std::max(80.0, height - top - 46.0);
    const double cell = fieldHeight / static_cast<double>(std::max<std::size_t>(1, map.rows));
    for (std::size_t row = 0; row < map.rows; ++row)
        drawRow(svg, map, row, left, top + fieldHeight - cell * static_cast<double>(row + 1), fieldWidth, cell);
    for (const Tick& tick : ticksOf(map.x, static_cast<int>(fieldWidth / 70)))
        svg.text(left + fieldWidth * shareAlong(map.x, tick.value), top + fieldHeight + 16, tick.text, Anchor::Middle,
                 11);
    for (const Tick& tick : ticksOf(map.y, static_cast<int>(fieldHeight / 40)))
        svg.text(left - 6, top + fieldHeight * (1.0 - shareAlong(map.y, tick.value)) + 4, tick.text, Anchor::End, 11);
    svg.text(left + fieldWidth / 2, top + fieldHeight + 34, map.x.label, Anchor::Middle);
    svg.text(14, top + fieldHeight / 2, map.y.label, Anchor::Middle, 12, 0x303030, -90);
    svg.text(left, 20, map.title, Anchor::Start, 14, 0x101010);
    drawScale(svg, map, left + fieldWidth + 16, top, fieldHeight);
    return svg.finished();
}

std::string csvOf(const HeatMap& map)
{
    std::string out = "x,y,value\n";
    for (std::size_t row = 0; row < map.rows; ++row)
        for (std::size_t column = 0; column < map.columns; ++column) {
            const auto middle = [](const Axis& axis, std::size_t i, std::size_t count) {
                return valueAlong(axis, (static_cast<double>(i) + 0.5) / static_cast<double>(count));
            };
            const double value = map.at(column, row);
            out += shortest(middle(map.x, column, map.columns)) + "," + shortest(middle(map.y, row, map.rows)) + "," +
                   (std::isnan(value) ? std::string() : shortest(value)) + "\n";
        }
    return out;
}

} // namespace reflectance
