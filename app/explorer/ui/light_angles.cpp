#include "app/explorer/ui/light_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance::explorer {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

} // namespace

LightAngles anglesOf(const Vec3d& v)
{
    return {std::atan2(v.x, v.z) / degree, std::atan2(v.y, std::hypot(v.x, v.z)) / degree, length(v)};
}

Vec3d vectorOf(const LightAngles& angles)
{
    const double azimuth = angles.azimuth * degree;
    const double elevation = angles.elevation * degree;
    const double across = angles.distance * std::cos(elevation);
    return {across * std::sin(azimuth), angles.distance * std::sin(elevation), across * std::cos(azimuth)};
}

double strengthOf(const Vec3d& intensity)
{
    return std::max({intensity.x, intensity.y, intensity.z});
}

Vec3d tintOf(const Vec3d& intensity)
{
    const double strength = strengthOf(intensity);
    return strength > 0.0 ? intensity / strength : Vec3d(1.0);
}

} // namespace reflectance::explorer
