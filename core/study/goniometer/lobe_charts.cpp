#include "core/study/goniometer/lobe_charts.h"

#include "core/base/text.h"
#include "core/math/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace reflectance {
namespace {

constexpr double widest = 89.0; ///< degrees of the viewer: what formulas are drawn to

/// The index of a difference of azimuths in the grid; nothing where no sample is within a thousandth of a degree.
std::optional<std::size_t> azimuthIndex(const LabSetup& setup, double deltaPhi)
{
    const auto& axis = setup.shape.axes[2];
    for (std::size_t i = 0; i < axis.size(); ++i)
        if (std::fabs(axis[i] - deltaPhi) < radians(0.001))
            return i;
    return std::nullopt;
}

/// Cells in the plane of incidence by signed viewing angle (degrees), from the light's side to the other.
std::vector<std::pair<double, std::size_t>> cellsInPlane(const LabSetup& setup, std::size_t incidence)
{
    const auto& axes = setup.shape.axes;
    std::vector<std::pair<double, std::size_t>> cells;
    for (const double side : {-1.0, 1.0}) {
        const auto phi = azimuthIndex(setup, side < 0.0 ? 0.0 : std::numbers::pi);
        for (std::size_t r = 0; phi && r < axes[1].size(); ++r)
            if (side > 0.0 || axes[1][r] > 0.0)
                cells.emplace_back(side * degrees(axes[1][r]),
                                   (incidence * axes[1].size() + r) * axes[2].size() + *phi);
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

DirectionPair inPlane(double thetaI, double viewer)
{
    return directionsAt(AngleSystem::Isotropic,
                        {thetaI, std::fabs(radians(viewer)), viewer < 0.0 ? 0.0 : std::numbers::pi});
}

/// Of the light as it was measured: at the horizon half a degree above it.
double measuredIncidence(const LabSetup& setup, std::size_t incidence)
{
    return std::min(setup.shape.axes[0][incidence], radians(89.5));
}

} // namespace

std::size_t nearestIncidence(const LabSetup& setup, double thetaI)
{
    const auto& axis = setup.shape.axes[0];
    const auto nearer = [thetaI](double a, double b) { return std::fabs(a - thetaI) < std::fabs(b - thetaI); };
    return static_cast<std::size_t>(std::min_element(axis.begin(), axis.end(), nearer) - axis.begin());
}

Series tracedSeries(const LabRun& run, const std::string& name, std::size_t incidence, ChartColor color)
{
    Series series{name, color, {}, {}, {}, Mark::Dots, false, false, {}};
    for (const auto& [viewer, cell] : cellsInPlane(run.setup, incidence)) {
        if (run.cells[cell].batches < 2)
            continue;
        const double scale = std::numbers::pi * directionsOf(run.setup, cell).L.z;
        const GreyCell grey = greyOf(run, cell);
        series.x.push_back(viewer);
        series.y.push_back(scale * grey.f);
        series.spread.push_back(scale * grey.error);
    }
    return series;
}

Series formulaSeries(const NamedFactor& formula, double thetaI, ChartColor color)
{
    Series series{formula.name, color, {}, {}, {}, Mark::Line, false, false, {}};
    std::vector<DirectionPair> pairs;
    for (double viewer = -widest; viewer <= widest; viewer += 0.5) {
        series.x.push_back(viewer);
        pairs.push_back(inPlane(thetaI, viewer));
    }
    series.y = formula.factor(pairs);
    return series;
}

Chart planeChart(const LabRun& run, const std::string& name, std::size_t incidence,
                 const std::vector<NamedFactor>& formulas)
{
    const double thetaI = measuredIncidence(run.setup, incidence);
    Chart chart;
    chart.title = "Light at " + general(degrees(thetaI), 3) + " degrees";
    chart.x = {"theta_r (degrees; light on the left)", -90.0, 90.0, AxisScale::Linear, 30.0};
    for (std::size_t i = 0; i < formulas.size(); ++i)
        chart.series.push_back(formulaSeries(formulas[i], thetaI, seriesColor(i + 1)));
    chart.series.push_back(tracedSeries(run, name, incidence, seriesColor(0)));
    std::vector<double> all{0.0};
    for (const Series& series : chart.series)
        all.insert(all.end(), series.y.begin(), series.y.end());
    chart.y = axisAround("pi f cos(theta_i)", all);
    chart.guides = {{degrees(thetaI), true, "R"}, {-degrees(thetaI), true, "L"}};
    return chart;
}

PolarChart lobeChart(const LabRun& run, const std::string& name, std::size_t incidence,
                     const std::vector<NamedFactor>& formulas)
{
    const double thetaI = measuredIncidence(run.setup, incidence);
    const double perFactor = 1.0 / std::cos(thetaI);
    PolarChart chart;
    chart.radiusLabel = "\u03C0 f";
    const auto add = [&](const Series& series, bool bars) {
        PolarChart::Curve curve{series.name, series.color, {}, {}, !bars, {}};
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            curve.angle.push_back(radians(series.x[i]));
            curve.radius.push_back(perFactor * series.y[i]);
            if (bars)
                curve.spread.push_back(perFactor * series.spread[i]);
        }
        chart.curves.push_back(std::move(curve));
    };
    for (std::size_t i = 0; i < formulas.size(); ++i)
        add(formulaSeries(formulas[i], thetaI, seriesColor(i + 1)), false);
    add(tracedSeries(run, name, incidence, seriesColor(0)), true);
    double largest = 1e-3;
    // What was traced rules; before that, whatever there is.
    const auto grow = [&](const PolarChart::Curve& curve) {
        for (const double radius : curve.radius)
            if (std::isfinite(radius))
                largest = std::max(largest, radius);
    };
    if (chart.curves.back().radius.empty())
        std::for_each(chart.curves.begin(), chart.curves.end(), grow);
    else
        grow(chart.curves.back());
    chart.largest = 1.15 * largest;
    chart.rays = {-thetaI, thetaI};
    chart.rayNames = {"L", "R"};
    return chart;
}

} // namespace reflectance
