#include "core/measured/angles.h"

#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

/// Angle from N: exact at the pole and at the horizon, where an arc cosine loses half of its digits.
double polarAngle(const Vec3d& v)
{
    return std::atan2(std::hypot(v.x, v.y), v.z);
}

double azimuthBetween(const Vec3d& L, const Vec3d& V)
{
    return std::atan2(L.x * V.y - L.y * V.x, L.x * V.x + L.y * V.y);
}

/// Rotates by phi about z.
Vec3d turned(const Vec3d& v, double phi)
{
    const double c = std::cos(phi);
    const double s = std::sin(phi);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

/// Rotates by theta from z towards x.
Vec3d tilted(const Vec3d& v, double theta)
{
    const double c = std::cos(theta);
    const double s = std::sin(theta);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

Angles halfDifferenceOf(const Vec3d& L, const Vec3d& V)
{
    const Vec3d sum = L + V;
    const Vec3d H = normalized(sum);
    const double phi = std::atan2(H.y, H.x);
    const double theta = polarAngle(H);
    const Vec3d d = tilted(turned(L, -phi), -theta);
    const double azimuth = std::atan2(d.y, d.x);
    return {theta, std::atan2(length(L - V), length(sum)), azimuth < 0.0 ? azimuth + pi : azimuth};
}

/// The mirror direction of L, and two directions across it: towards N, and to the side.
struct SpecularFrame {
    Vec3d S, towardsN, aside;
};

SpecularFrame specularFrame(const Vec3d& L)
{
    const Vec3d S{-L.x, -L.y, L.z};
    const double phi = std::atan2(S.y, S.x);
    const Vec3d towardsN = turned({-S.z, 0.0, std::hypot(S.x, S.y)}, phi);
    return {S, towardsN, cross(S, towardsN)};
}

Angles specularOf(const Vec3d& L, const Vec3d& V)
{
    const SpecularFrame frame = specularFrame(L);
    const double radial = 2.0 * std::atan2(length(V - frame.S), length(V + frame.S));
    return {polarAngle(L), radial, std::atan2(dot(V, frame.aside), dot(V, frame.towardsN))};
}

} // namespace

std::span<const std::string_view> angleNames(AngleSystem system)
{
    static constexpr std::string_view directions[] = {"theta_i", "theta_r", "delta_phi"};
    static constexpr std::string_view halves[] = {"theta_h", "theta_d", "phi_d"};
    static constexpr std::string_view speculars[] = {"theta_i", "radial", "azimuth"};
    if (system == AngleSystem::HalfDifference)
        return halves;
    if (system == AngleSystem::Specular)
        return speculars;
    return std::span(directions).first(system == AngleSystem::Polar ? 2 : 3);
}

double largestAngle(AngleSystem system, std::size_t axis)
{
    if (axis == 0 || (axis == 1 && system != AngleSystem::Specular))
        return pi / 2.0;
    return axis == 1 || system == AngleSystem::HalfDifference ? pi : 2.0 * pi;
}

Angles anglesOf(AngleSystem system, const Vec3d& L, const Vec3d& V)
{
    if (system == AngleSystem::HalfDifference)
        return halfDifferenceOf(L, V);
    if (system == AngleSystem::Specular)
        return specularOf(L, V);
    return {polarAngle(L), polarAngle(V), system == AngleSystem::Polar ? 0.0 : azimuthBetween(L, V)};
}

Vec3d directionAt(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

DirectionPair directionsAt(AngleSystem system, const Angles& at)
{
    if (system == AngleSystem::Specular) {
        const Vec3d L = directionAt(at[0], 0.0);
        const SpecularFrame frame = specularFrame(L);
        const Vec3d d = directionAt(at[1], at[2]);
        return {L, d.z * frame.S + d.x * frame.towardsN + d.y * frame.aside};
    }
    if (system != AngleSystem::HalfDifference)
        return {directionAt(at[0], 0.0), directionAt(at[1], system == AngleSystem::Polar ? pi : at[2])};
    const Vec3d d = directionAt(at[1], at[2]);
    return {tilted(d, at[0]), tilted({-d.x, -d.y, d.z}, at[0])};
}

} // namespace reflectance
