#include "core/illumination/light.h"

#include "core/math/angle.h"

#include <algorithm>

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
    return squaredChord(light.angularRadius);
}

} // namespace reflectance
