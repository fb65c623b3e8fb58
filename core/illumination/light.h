// Lights, and what of them arrives at a point.
#pragma once

#include "core/math/vec.h"

#include <string>

namespace reflectance {

enum class LightKind { Directional, Point };

/// A directional light shines from `direction` with intensity I everywhere. A point light stands at `position` and
/// I / r^2 arrives at distance r (scene units: the object's bounding sphere has radius 1).
/// I is the radiance of a perfect white diffuser that faces the light; 1 fills the sensor at exposure 0.
struct Light {
    std::string name = "light";
    LightKind kind = LightKind::Directional;
    Vec3d direction{0.5, 0.8, 0.6}; ///< from the origin to the light; any length but 0
    Vec3d position{2.0, 2.4, 2.0};
    Vec3d intensity{1.0, 1.0, 1.0}; ///< I for the light primaries red, green, blue; >= 0
    double angularRadius = 0.0;     ///< degrees, 0 .. 90: how large a mirror shows it; no other model depends on it
    bool on = true;

    friend bool operator==(const Light&, const Light&) = default;
};

/// The light as it arrives at a point.
struct Arrival {
    Vec3d L; ///< unit, to the light; (0,0,0) where the point is the light's own position
    Vec3d I; ///< per primary; 0 where the point is the light's own position (hazard H40)
};
[[nodiscard]] Arrival arrivalAt(const Light& light, const Vec3d& point);

/// (2 sin(a/2))^2 for the light's angular radius a: the squared chord from its centre to its rim.
[[nodiscard]] double discOf(const Light& light);

/// Below this distance a point light's 1/r^2 stops growing: 1e-6 of the object's radius (hazard H40).
inline constexpr double smallestLightDistance = 1e-6;

} // namespace reflectance
