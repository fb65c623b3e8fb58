#include "core/study/curves.h"

#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

using std::numbers::pi;

std::string degreesText(double radians)
{
    return std::to_string(std::lround(radians * 180.0 / pi)) + "\u00B0";
}

} // namespace

bool setsTheScale(double theta, double thetaI)
{
    return std::fabs(theta) <= 85.0 * pi / 180.0 || std::fabs(theta - thetaI) < 2.0 * pi / 180.0;
}

Vec3d directionInPlane(double theta)
{
    return {std::sin(theta), 0.0, std::cos(theta)};
}

double numberOf(const Vec3d& factor, double cosine, const CurveSettings& settings)
{
    const double unit = settings.quantity == Quantity::Factor       ? 1.0
                        : settings.quantity == Quantity::BrdfCosine ? 1.0 / pi
                                                                    : 1.0 / (pi * cosine);
    switch (settings.shown) {
    case Shown::Red:
        return unit * factor.x;
    case Shown::Green:
        return unit * factor.y;
    case Shown::Blue:
        return unit * factor.z;
    case Shown::Mean:
        break;
    }
    return unit * ((factor.x + factor.y + factor.z) / 3.0);
}

std::string valueLabel(const CurveSettings& settings)
{
    constexpr std::string_view channels[] = {"", ", red", ", green", ", blue"};
    return std::string(labelOf(settings.quantity)) + std::string(channels[static_cast<int>(settings.shown)]);
}

std::string_view labelOf(Quantity quantity)
{
    constexpr std::string_view labels[] = {"factor = \u03C0 f cos \u03B8_i", "BRDF f (1/sr)", "f cos \u03B8_i (1/sr)"};
    return labels[static_cast<int>(quantity)];
}

std::vector<double> viewingAngles(double thetaI)
{
    std::vector<double> angles;
    for (int k = -180; k <= 180; ++k)
        angles.push_back(k * pi / 360.0);
    for (double offset = 1e-5; offset < 0.1; offset *= 1.15)
        angles.insert(angles.end(), {thetaI - offset, thetaI + offset});
    angles.push_back(thetaI);
    std::erase_if(angles, [](double angle) { return std::fabs(angle) > pi / 2; });
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

std::vector<double> towards(const NamedSurface& surface, const CurveSettings& settings, std::span<const Vec3d> viewers)
{
    const Vec3d L = directionInPlane(-settings.thetaI);
    std::vector<Observation> rows;
    rows.reserve(viewers.size());
    for (const Vec3d& V : viewers)
        rows.push_back({{0, 0, 1}, V, {{L, {1, 1, 1}, 0.0}}});
    std::vector<double> numbers;
    numbers.reserve(rows.size());
    for (const Vec3d& value : evaluate(*surface.model, surface.values, rows, Precision::Double, surface.measured))
        numbers.push_back(numberOf(value, L.z, settings));
    return numbers;
}

std::vector<double> inPlane(const NamedSurface& surface, const CurveSettings& settings,
                            const std::vector<double>& thetaR)
{
    std::vector<Vec3d> viewers(thetaR.size());
    std::transform(thetaR.begin(), thetaR.end(), viewers.begin(), directionInPlane);
    return towards(surface, settings, viewers);
}

Chart overTheta(const std::vector<NamedSurface>& surfaces, const CurveSettings& settings)
{
    const std::vector<double> angles = viewingAngles(settings.thetaI);
    std::vector<double> degrees(angles.size());
    std::transform(angles.begin(), angles.end(), degrees.begin(), [](double angle) { return angle * 180.0 / pi; });
    Chart chart;
    chart.title = "\u03B8_i = " + degreesText(settings.thetaI);
    chart.x = {"\u03B8_r (degrees; positive away from the light)", -90.0, 90.0, AxisScale::Linear, 30.0};
    std::vector<double> all{settings.scale == AxisScale::Linear ? 0.0 : 1e-3};
    for (const NamedSurface& surface : surfaces) {
        Series series;
        series.name = surface.name;
        series.color = surface.color;
        series.x = degrees;
        series.y = inPlane(surface, settings, angles);
        for (std::size_t i = 0; i < angles.size(); ++i)
            if (setsTheScale(angles[i], settings.thetaI))
                all.push_back(series.y[i]);
        chart.series.push_back(std::move(series));
    }
    if (settings.scale == AxisScale::Log) // what underflows must not stretch the axis over 300 decades
        std::erase_if(all, [](double value) { return value < 1e-6; });
    chart.y = axisAround(valueLabel(settings), all, settings.scale);
    chart.guides = {{-settings.thetaI * 180.0 / pi, true, "L"}, {settings.thetaI * 180.0 / pi, true, "R"}};
    return chart;
}

PolarChart aboutThePoint(const std::vector<NamedSurface>& surfaces, const CurveSettings& settings)
{
    PolarChart chart;
    chart.title = "\u03B8_i = " + degreesText(settings.thetaI);
    chart.radiusLabel = valueLabel(settings);
    chart.rays = {-settings.thetaI, settings.thetaI};
    chart.rayNames = {"L", "R"};
    const std::vector<double> angles = viewingAngles(settings.thetaI);
    double largest = 0.0;
    for (const NamedSurface& surface : surfaces) {
        PolarChart::Curve curve;
        curve.name = surface.name;
        curve.color = surface.color;
        curve.angle = angles;
        curve.radius = inPlane(surface, settings, angles);
        for (std::size_t i = 0; i < angles.size(); ++i)
            if (std::isfinite(curve.radius[i]) && setsTheScale(angles[i], settings.thetaI))
                largest = std::max(largest, curve.radius[i]);
        chart.curves.push_back(std::move(curve));
    }
    chart.largest = largest > 0.0 ? 1.05 * largest : 1.0;
    return chart;
}

} // namespace reflectance
