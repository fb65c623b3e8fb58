// A micro-surface, facets and effects set up in one line, and a mean with its standard error.
#pragma once

#include "core/study/goniometer/laboratory.h"

#include <cmath>
#include <numbers>

namespace reflectance {

inline constexpr double degree = std::numbers::pi / 180.0;

inline Facets facetsNamed(const std::string& id, const ParameterValues& values = {})
{
    const Model& model = **findModel(id);
    return *facetsOf(model, flatValues(model.text, values));
}

inline MicroTracer tracerOf(const std::string& surface, const Facets& facets, const Effects& effects = {})
{
    return {*microSurface(surface), facets, effects};
}

/// Both azimuths from the x axis of the mean plane, degrees.
inline DirectionPair pairAt(double thetaI, double thetaR, double deltaPhi)
{
    return directionsAt(AngleSystem::Isotropic, {thetaI * degree, thetaR * degree, deltaPhi * degree});
}

struct Mean {
    double value = 0.0, error = 0.0;
    std::size_t lost = 0;
};

/// Of the first entry of the factor.
inline Mean meanOf(const MicroTracer& tracer, const DirectionPair& at, std::optional<double> azimuth, int batches,
                   std::uint64_t seed = 1)
{
    LabCell cell;
    Mean mean;
    for (int i = 0; i < batches; ++i) {
        const auto batch = tracer.trace(at, azimuth, CounterRandom(seed, 0, static_cast<std::uint64_t>(i)));
        cell.take({batch.factor.rows[0].x}, 1);
        mean.lost += batch.lost;
    }
    mean.value = cell.mean[0];
    mean.error = cell.standardError(0);
    return mean;
}

} // namespace reflectance
