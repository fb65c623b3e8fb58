#include "core/study/lens/passive_angles.h"

#include "core/study/properties/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

/// Denser towards grazing light, where surfaces that are not passive mostly fail.
constexpr std::array anglesInDegrees{0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 75.0, 80.0, 83.0, 86.0, 88.0, 89.0};
constexpr double slack = 1e-6; ///< of the quadrature

/// The angle's albedo between the two nearest ones; that of the last beyond it.
double between(const std::vector<double>& albedos, double degrees)
{
    const auto above = std::ranges::upper_bound(anglesInDegrees, degrees) - anglesInDegrees.begin();
    const auto high = std::min(static_cast<std::size_t>(above), albedos.size() - 1);
    const double from = anglesInDegrees[high - 1];
    return std::lerp(albedos[high - 1], albedos[high],
                     std::min(1.0, (degrees - from) / (anglesInDegrees[high] - from)));
}

} // namespace

PassiveAngles::PassiveAngles(const Scene& scene, const Progress& progress) : lights_(shiningLights(scene))
{
    const std::vector<double> values = valuesOf(scene);
    for (const double angle : anglesInDegrees) {
        if (progress.cancel) {
            albedos_.clear();
            return;
        }
        const Vec3d share = properties::HemisphereSums(angle).albedo(modelOf(scene), values).value;
        albedos_.push_back(std::max({share.x, share.y, share.z}));
    }
    if (std::ranges::none_of(albedos_, [](double share) { return share > 1.0 + slack; }))
        albedos_.clear();
}

bool PassiveAngles::exceededAt(const ViewSamples& samples, std::size_t sample) const
{
    if (albedos_.empty())
        return false;
    const Vec3d N{samples.Nx[sample], samples.Ny[sample], samples.Nz[sample]};
    const Vec3d P{samples.Px[sample], samples.Py[sample], samples.Pz[sample]};
    return std::ranges::any_of(lights_, [&](const Light& light) {
        const double cosine = dot(N, arrivalAt(light, P).L);
        if (!(cosine > 0.0))
            return false;
        const double degrees = std::acos(std::min(cosine, 1.0)) * 180.0 / std::numbers::pi;
        return between(albedos_, degrees) > 1.0 + slack;
    });
}

} // namespace reflectance
