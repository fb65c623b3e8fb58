#include "core/study/plots/lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

using std::numbers::pi;

/// Each once, in their order, those within 0 .. high.
std::vector<double> sorted(std::vector<double> angles, double high)
{
    std::erase_if(angles, [high](double angle) { return angle < 0.0 || angle > high; });
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

std::vector<double> ringsAbout(double thetaI)
{
    std::vector<double> rings{thetaI};
    for (int k = 0; k <= 22; ++k)
        rings.push_back(k * pi / 44);
    for (const double off : {0.001, 0.004, 0.015, 0.04})
        rings.insert(rings.end(), {thetaI - off, thetaI + off});
    return sorted(std::move(rings), pi / 2);
}

std::vector<double> columns()
{
    std::vector<double> angles;
    for (int k = 0; k <= 48; ++k)
        angles.push_back(k * pi / 24);
    for (const double off : {0.002, 0.008, 0.03, 0.07})
        angles.insert(angles.end(), {off, 2 * pi - off});
    return sorted(std::move(angles), 2 * pi);
}

} // namespace

std::optional<LobeChart> lobesOf(const std::vector<NamedSurface>& surfaces, const CurveSettings& settings,
                                 const Progress& progress)
{
    LobeChart chart;
    chart.title = "\u03B8_i = " + std::to_string(std::lround(settings.thetaI * 180.0 / pi)) + "\u00B0";
    chart.radiusLabel = valueLabel(settings);
    chart.theta = ringsAbout(settings.thetaI);
    chart.phi = columns();
    chart.rays = {{"L", settings.thetaI, pi}, {"R", settings.thetaI, 0.0}};
    double largest = 0.0;
    for (const NamedSurface& surface : surfaces) {
        LobeChart::Lobe lobe{surface.name, surface.color, {}};
        std::vector<Vec3d> viewers(chart.phi.size());
        for (const double theta : chart.theta) {
            if (progress.cancel)
                return std::nullopt;
            std::transform(chart.phi.begin(), chart.phi.end(), viewers.begin(), [theta](double phi) {
                return Vec3d{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
            });
            const std::vector<double> ring = towards(surface, settings, viewers);
            lobe.radius.insert(lobe.radius.end(), ring.begin(), ring.end());
        }
        for (std::size_t i = 0; i < lobe.radius.size(); ++i)
            if (std::isfinite(lobe.radius[i]) && setsTheScale(chart.theta[i / chart.phi.size()], settings.thetaI))
                largest = std::max(largest, lobe.radius[i]);
        chart.lobes.push_back(std::move(lobe));
    }
    chart.largest = largest > 0.0 ? 1.05 * largest : 1.0;
    return chart;
}

} // namespace reflectance
