#include "core/base/text.h"
#include "core/chart/chart.h"
#include "core/chart/csv_field.h"
#include "core/chart/lobe_chart.h"

#include <algorithm>

namespace reflectance {
std::string csvField(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string csvOf(const Chart& chart)
{
    std::string out = "series,x,y,spread\n";
    for (const Series& series : chart.series)
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
            out += csvField(series.name) + "," + shortest(series.x[i]) + "," + shortest(series.y[i]) + "," +
                   (i < series.spread.size() ? shortest(series.spread[i]) : std::string()) + "\n";
    return out;
}

std::string csvOf(const PolarChart& chart)
{
    std::string out = "series,angle,radius\n";
    for (const PolarChart::Curve& curve : chart.curves)
        for (std::size_t i = 0; i < std::min(curve.angle.size(), curve.radius.size()); ++i)
            out += csvField(curve.name) + "," + shortest(curve.angle[i]) + "," + shortest(curve.radius[i]) + "\n";
    return out;
}

std::string csvOf(const LobeChart& chart)
{
    std::string out = "series,theta,phi,radius\n";
    for (const LobeChart::Lobe& lobe : chart.lobes)
        for (std::size_t ring = 0; ring < chart.theta.size(); ++ring)
            for (std::size_t column = 0; column < chart.phi.size(); ++column)
                out += csvField(lobe.name) + "," + shortest(chart.theta[ring]) + "," + shortest(chart.phi[column]) +
                       "," + shortest(lobe.radius[chart.at(ring, column)]) + "\n";
    return out;
}

} // namespace reflectance
