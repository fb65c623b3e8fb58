#include "core/base/text.h"
#include "core/chart/chart.h"

#include <algorithm>

namespace reflectance {
namespace {

/// A field of a comma-separated line.
std::string field(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

} // namespace

std::string csvOf(const Chart& chart)
{
    std::string out = "series,x,y,spread\n";
    for (const Series& series : chart.series)
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
            out += field(series.name) + "," + shortest(series.x[i]) + "," + shortest(series.y[i]) + "," +
                   (i < series.spread.size() ? shortest(series.spread[i]) : std::string()) + "\n";
    return out;
}

std::string csvOf(const PolarChart& chart)
{
    std::string out = "series,angle,radius\n";
    for (const PolarChart::Curve& curve : chart.curves)
        for (std::size_t i = 0; i < std::min(curve.angle.size(), curve.radius.size()); ++i)
            out += field(curve.name) + "," + shortest(curve.angle[i]) + "," + shortest(curve.radius[i]) + "\n";
    return out;
}

} // namespace reflectance
