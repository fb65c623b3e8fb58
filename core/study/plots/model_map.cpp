#include "core/reflectance/evaluate.h"
#include "core/study/plots/lobes.h"

namespace reflectance {

std::optional<HeatMap> modelMap(const NamedSurface& surface, const CurveSettings& settings, double deltaPhi,
                                const Progress& progress)
{
    TableMapSettings shape;
    shape.deltaPhi = deltaPhi;
    shape.logarithmic = settings.scale == AxisScale::Log;
    const auto number = [&](const Vec3d& L, const Vec3d& V) -> std::optional<double> {
        if (progress.cancel)
            return std::nullopt;
        const Observation row{{0, 0, 1}, V, {{L, {1, 1, 1}, 0.0}}};
        return numberOf(evaluate(*surface.model, surface.values, {&row, 1}, Precision::Double, surface.measured)[0],
                        L.z, settings);
    };
    HeatMap map = angleMap(number, shape, valueLabel(settings));
    map.title = surface.name;
    if (progress.cancel)
        return std::nullopt;
    return map;
}

} // namespace reflectance
