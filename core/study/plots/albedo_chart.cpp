#include "core/study/plots/albedo_chart.h"

#include "core/study/properties/albedo.h"

#include <mutex>

namespace reflectance {
namespace {

constexpr double angles[] = {0, 10, 20, 30, 40, 50, 60, 70, 75, 80, 85, 88};

/// Grids take longer to make than to use: they stay.
std::vector<properties::HemisphereSums>& sums()
{
    static std::vector<properties::HemisphereSums> made(std::begin(angles), std::end(angles));
    return made;
}

std::mutex& grids()
{
    static std::mutex mutex;
    return mutex;
}

} // namespace

std::optional<Chart> albedoOver(const std::vector<NamedSurface>& surfaces, Shown shown, Progress& progress)
{
    const std::lock_guard lock(grids());
    CurveSettings channel;
    channel.shown = shown;
    constexpr const char* names[] = {"", ", red", ", green", ", blue"};
    Chart chart;
    chart.title = "Directional albedo";
    chart.x = {"\u03B8_i (degrees)", 0.0, 90.0, AxisScale::Linear, 30.0};
    std::vector<double> all{0.0, 1.0};
    double done = 0.0;
    for (const NamedSurface& surface : surfaces) {
        Series series;
        series.name = surface.name;
        series.color = surface.color;
        series.mark = Mark::LineAndDots;
        for (properties::HemisphereSums& at : sums()) {
            if (progress.cancel)
                return std::nullopt;
            at.lookUpIn(surface.measured.exact);
            const properties::Share share = at.albedo(*surface.model, surface.values);
            series.x.push_back(at.angle());
            series.y.push_back(numberOf(share.value, 1.0, channel));
            series.spread.push_back(share.error);
            progress.done = ++done / static_cast<double>(surfaces.size() * std::size(angles));
        }
        all.insert(all.end(), series.y.begin(), series.y.end());
        chart.series.push_back(std::move(series));
    }
    chart.y = axisAround(std::string("albedo: what leaves over what arrives") + names[static_cast<int>(shown)], all);
    chart.guides = {{1.0, false, "as much as arrives"}};
    return chart;
}

} // namespace reflectance
