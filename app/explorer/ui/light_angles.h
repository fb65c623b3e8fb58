// A light's place as angles, the way a photographer says it: azimuth about the vertical, elevation above the horizon.
#pragma once

#include "core/illumination/light.h"

#include <cstddef>

namespace reflectance::explorer {

struct LightAngles {
    double azimuth = 0.0;   ///< degrees, -180 .. 180; 0 is +z (the default view's side), 90 is +x
    double elevation = 0.0; ///< degrees, -90 .. 90; 90 is straight above (+y)
    double distance = 1.0;  ///< scene units
};

[[nodiscard]] LightAngles anglesOf(const Vec3d& v);

/// At elevation +-90 the azimuth survives: the cosine of a right angle in double is 6e-17, not 0.
[[nodiscard]] Vec3d vectorOf(const LightAngles& angles);

/// The unit vector whose component `axis` (0, 1, 2) is `value`, within -1 .. 1, and whose others keep their ratio.
[[nodiscard]] Vec3d withComponent(const Vec3d& unit, std::size_t axis, double value);

/// Largest channel of the intensity; the colour is what is left of it: intensity = strength * tint.
[[nodiscard]] double strengthOf(const Vec3d& intensity);
[[nodiscard]] Vec3d tintOf(const Vec3d& intensity); ///< white for a light of strength 0

} // namespace reflectance::explorer
