#include "app/explorer/ui/light_angles.h"

#include <algorithm>
#include <array>
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

Vec3d withComponent(const Vec3d& unit, std::size_t axis, double value)
{
    std::array<double, 3> v = {unit.x, unit.y, unit.z};
    double& next = v[(axis + 1) % 3];
    double& last = v[(axis + 2) % 3];
    if (next == 0.0 && last == 0.0)
        next = 1.0; // along the axis every direction across it is as good
    // Never quite 0, so that the ratio of the others comes back when the value leaves 1 again.
    const double across = std::max(std::sqrt(std::max(0.0, 1.0 - value * value)), 1e-9);
    const double factor = across / std::hypot(next, last);
    v[axis] = value;
    next *= factor;
    last *= factor;
    return {v[0], v[1], v[2]};
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
