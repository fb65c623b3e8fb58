#include "core/study/tables/table_maps.h"

#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace reflectance {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double entryOf(const Mat3d& f, const TableMapSettings& settings)
{
    const auto component = [](const Vec3d& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; };
    if (settings.row < 0)
        return (f.rows[0].x + f.rows[1].y + f.rows[2].z) / 3.0;
    return component(f.rows[static_cast<std::size_t>(settings.row)], settings.column);
}

HeatMap emptyMap(const TableMapSettings& settings)
{
    HeatMap map;
    map.x = {"\u03B8_r (degrees)", 0.0, 90.0, AxisScale::Linear, 30.0};
    map.y = {"\u03B8_i (degrees)", 0.0, 90.0, AxisScale::Linear, 30.0};
    map.columns = map.rows = settings.steps;
    map.values.assign(settings.steps * settings.steps, nothing);
    return map;
}

double largestIn(const std::vector<double>& values)
{
    double largest = 0.0;
    for (const double value : values)
        if (std::isfinite(value))
            largest = std::max(largest, std::fabs(value));
    return largest;
}

} // namespace

HeatMap angleMap(const AngleFunction& function, const TableMapSettings& settings, std::string label)
{
    HeatMap map = emptyMap(settings);
    const double step = std::numbers::pi / 2 / static_cast<double>(settings.steps);
    for (std::size_t row = 0; row < map.rows; ++row)
        for (std::size_t column = 0; column < map.columns; ++column) {
            const Vec3d L = directionAt((static_cast<double>(row) + 0.5) * step, 0.0);
            const Vec3d V = directionAt((static_cast<double>(column) + 0.5) * step, radians(settings.deltaPhi));
            map.values[row * map.columns + column] = function(L, V).value_or(nothing);
        }
    const double largest = largestIn(map.values);
    if (!settings.logarithmic || largest == 0.0) {
        map.scale = {std::move(label), 0.0, largest > 0.0 ? largest : 1.0, AxisScale::Linear};
        return map;
    }
    double smallest = largest;
    for (const double value : map.values)
        if (value > 1e-6 * largest)
            smallest = std::min(smallest, value);
    map.scale = {std::move(label), std::min(smallest, 0.5 * largest), largest, AxisScale::Log};
    return map;
}

HeatMap valueMap(const Measurement& measurement, const TableMapSettings& settings)
{
    return angleMap(
        [&](const Vec3d& L, const Vec3d& V) -> std::optional<double> {
            const auto f = brdfAt(measurement, L, V);
            return f ? std::optional(entryOf(*f, settings)) : std::nullopt;
        },
        settings, "f (1/sr)");
}

PolarChart polarSlice(const Measurement& measurement, double thetaI, const TableMapSettings& settings)
{
    PolarChart chart;
    chart.title = "\u03B8_i = " + general(thetaI, 3) + "\u00B0";
    chart.radiusLabel = "f (1/sr)";
    chart.rays = {-radians(thetaI), radians(thetaI)};
    chart.rayNames = {"L", "R"};
    const Vec3d L = directionAt(radians(thetaI), 0.0);
    PolarChart::Curve curve{"", seriesColor(0), {}, {}};
    for (int half = -179; half <= 179; ++half) {
        const double theta = radians(0.5 * half);
        const double azimuth = radians(settings.deltaPhi) + (half < 0 ? std::numbers::pi : 0.0);
        const auto f = brdfAt(measurement, L, directionAt(std::fabs(theta), azimuth));
        curve.angle.push_back(theta);
        curve.radius.push_back(f ? entryOf(*f, settings) : nothing);
    }
    const double largest = largestIn(curve.radius);
    chart.largest = largest > 0.0 ? 1.05 * largest : 1.0;
    chart.curves.push_back(std::move(curve));
    return chart;
}

HeatMap residualMap(const Measurement& measurement, const TableMapSettings& settings)
{
    HeatMap map = emptyMap(settings);
    const ReciprocityMap residuals = reciprocityMap(measurement, radians(settings.deltaPhi), settings.steps);
    map.columns = map.rows = residuals.theta.size();
    map.values = residuals.residual;
    // Cells stand about the angles that were looked at.
    const double half = residuals.theta.size() > 1 ? 0.5 * degrees(residuals.theta[1] - residuals.theta[0]) : 45.0;
    map.x.low = map.y.low = -half;
    map.x.high = map.y.high = residuals.theta.empty() ? half : degrees(residuals.theta.back()) + half;
    const double largest = largestIn(map.values);
    map.diverging = true;
    map.scale = {"f(i,r) \u2212 f(r,i) (1/sr)", largest > 0.0 ? -largest : -1.0, largest > 0.0 ? largest : 1.0,
                 AxisScale::Linear};
    return map;
}

} // namespace reflectance
