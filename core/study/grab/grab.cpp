#include "core/study/grab/grab.h"

#include "core/reflectance/evaluate.h"
#include "core/study/grab/spot_angle.h"

#include <cmath>

namespace reflectance {
namespace {

/// Below this N.V a point is seen along its surface: the mirror's direction would lie in the surface, too.
constexpr double grazing = 1e-3;
/// Below this sine between N and L the terminator would have no side to come from.
constexpr double straightAbove = 1e-6;
constexpr double nearestLight = 1e-3;

/// How far along a ray from P a point light goes: out to its distance from the origin, where the ray gets there.
double wayTo(double distance, const Vec3d& P, const Vec3d& direction, double fromP)
{
    const double along = dot(P, direction);
    const double root = along * along - dot(P, P) + distance * distance;
    const double way = root >= 0.0 ? std::sqrt(root) - along : 0.0;
    return way > nearestLight ? way : std::max(fromP, nearestLight);
}

} // namespace

SpotKind spotKindOf(const Scene& scene)
{
    const double s = std::sqrt(0.5);
    const Vec3d N{0.0, 0.0, 1.0}, V{s, 0.0, s}, mirror{-s, 0.0, s};
    constexpr double radius = 1.0; // degrees, for the model that shows the light itself
    const Observation rows[] = {{N, V, {{mirror, Vec3d(1.0), radius}}}, {N, V, {{V, Vec3d(1.0), radius}}}};
    const auto seen =
        evaluate(modelOf(scene), valuesOf(scene), rows, Precision::Double, lookUpsIn(scene.surface.table.get()));
    const auto sum = [](const Vec3d& v) { return v.x + v.y + v.z; };
    // A matte formula gives the same for both, but for rounding.
    return sum(seen[0]) > (1.0 + 1e-9) * sum(seen[1]) ? SpotKind::Mirrored : SpotKind::Facing;
}

Result<Light> withSpotAt(const Light& light, const Vec3d& eye, const ProbedPoint& point, SpotKind kind)
{
    const Vec3d& N = point.N;
    const Vec3d V = normalized(eye - point.P);
    const double NV = dot(N, V);
    if (!(NV > grazing))
        return Error{"the surface is seen from its edge there; aim at a part that faces the camera"};
    const Vec3d L = kind == SpotKind::Mirrored ? normalized(2.0 * NV * N - V) : N;
    Light moved = light;
    if (light.kind == LightKind::Directional)
        moved.direction = L;
    else
        moved.position = point.P + wayTo(length(light.position), point.P, L, length(light.position - point.P)) * L;
    return moved;
}

Result<Light> withTerminatorAt(const Light& light, const ProbedPoint& point)
{
    const Vec3d& N = point.N;
    const bool directional = light.kind == LightKind::Directional;
    const Vec3d from = directional ? normalized(light.direction) : light.position;
    const Vec3d flat = from - dot(N, from) * N;
    const double size = length(flat);
    if (!(size > straightAbove * length(from)))
        return Error{"the light stands straight above this point, so its shadow line has no side to come from; aim "
                     "elsewhere"};
    Light moved = light;
    if (directional) {
        moved.direction = flat / size;
        return moved;
    }
    // In the plane that touches the surface, as far from the origin as before.
    const double height = dot(N, point.P);
    const double square = dot(from, from) - height * height;
    moved.position = height * N + (square > 0.0 ? std::sqrt(square) / size : 1.0) * flat;
    return moved;
}

} // namespace reflectance
