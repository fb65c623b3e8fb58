// Observations from what was measured: a grid's samples, scattered samples as they were taken, and RGL's function where its
// surfaces shine.
#include "core/measured/merl.h"
#include "core/study/fit/observations.h"

#include <algorithm>
#include <numbers>

namespace reflectance {
namespace {

/// Over half and difference angles: dense where a highlight is narrow. Nearer to the horizon than 10 degrees RGL's own
/// instrument sees little.
constexpr std::size_t thetaHSteps = 30, thetaDSteps = 12, phiDSteps = 8;
const double lowest = std::sin(10.0 * std::numbers::pi / 180.0);

ObservedForm formOf(std::size_t channels)
{
    return channels == 1 ? ObservedForm::Grey : channels == 3 ? ObservedForm::Color : ObservedForm::Matrix;
}

Observations observed(const RglBrdf& brdf)
{
    Observations observations{brdf.provenance.name, formOf(brdf.channels), {}, {}, {}};
    for (const double thetaH : merl::thetaHNodes(thetaHSteps))
        for (const double thetaD : merl::evenNodes(thetaDSteps, std::numbers::pi / 2.0))
            for (const double phiD : merl::evenNodes(phiDSteps, std::numbers::pi)) {
                const auto [L, V] = directionsAt(AngleSystem::HalfDifference, {thetaH, thetaD, phiD});
                if (L.z < lowest || V.z < lowest)
                    continue;
                if (const auto f = brdfAt(brdf, L, V))
                    observe(observations, L, V, *f);
            }
    return observations;
}

Observations observed(const ScatteredBrdf& brdf)
{
    Observations observations{brdf.provenance.name, formOf(brdf.channels), {}, {}, {}};
    for (std::size_t i = 0; i < brdf.directions.size(); ++i) {
        Channels values{};
        std::copy_n(&brdf.values[i * brdf.channels], brdf.channels, values.begin());
        const auto& [L, V] = brdf.directions[i];
        if (L.z > 0.0 && V.z > 0.0)
            observe(observations, L, V, matrixOf(values, brdf.channels));
    }
    return observations;
}

Observations observed(const Table& table)
{
    return observationsOf(table);
}

} // namespace

Observations observationsOf(const Measurement& measurement)
{
    return std::visit([](const auto& m) { return observed(m); }, measurement);
}

} // namespace reflectance
