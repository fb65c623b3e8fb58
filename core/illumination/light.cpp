#include "core/illumination/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {

Arrival arrivalAt(const Light& light, const Vec3d& point)
{
    if (light.kind == LightKind::Directional)
        return {normalized(light.direction), light.intensity};
    const Vec3d toLight = light.position - point;
    const double distance = length(toLight);
    if (!(distance > 0.0))
        return {};
    const double r = std::max(distance, smallestLightDistance);
    return {normalized(toLight), light.intensity / (r * r)};
}

double discOf(const Light& light)
{
    const double rim = 2.0 * std::sin(light.angularRadius * std::numbers::pi / 360.0);
    return rim * rim;
}

} // namespace reflectance
