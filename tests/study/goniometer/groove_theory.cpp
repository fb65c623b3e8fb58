#include "tests/study/goniometer/groove_theory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;

/// Normals of the two walls of grooves along the azimuth pi/2 + turned.
struct Walls {
    Vec3d left, right;
    Walls(double slope, double turned)
        : left(std::sin(slope) * std::cos(turned), std::sin(slope) * std::sin(turned), std::cos(slope)),
          right(-left.x, -left.y, left.z)
    {
    }
};

/// The upper share of a wall with normal a that sees the direction d over the opposite ridge.
double open(const Vec3d& a, const Vec3d& d)
{
    return dot(a, d) > 0.0 ? std::min(1.0, 2.0 * d.z * a.z / dot(a, d)) : 0.0;
}

double onceFrom(const Vec3d& wall, const DirectionPair& at)
{
    const double area = 0.5 / wall.z * std::max(0.0, dot(wall, at.V)) / at.V.z; // as the viewer sees it
    return area * std::max(0.0, dot(wall, at.L)) * std::min(open(wall, at.L), open(wall, at.V));
}

/// Light meets `first` and leaves from `second`; walls of length 1.
double twiceFrom(const Vec3d& first, const Vec3d& second, double slope, const DirectionPair& at)
{
    const double light = std::max(0.0, dot(first, at.L));
    const double area = 0.5 / second.z * std::max(0.0, dot(second, at.V)) / at.V.z;
    if (light * area == 0.0)
        return 0.0;
    constexpr int steps = 100;
    const double lit = open(first, at.L);
    const double seen = open(second, at.V);
    const double w = pi - 2.0 * slope;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double t = 1.0 - lit * (i + 0.5) / steps;
            const double s = 1.0 - seen * (k + 0.5) / steps;
            const double apart = s * s + t * t - 2.0 * s * t * std::cos(w);
            sum += std::pow(std::sin(w), 2) * s * t / (2.0 * apart * std::sqrt(apart));
        }
    return area * seen * light * lit * sum / (steps * steps);
}

template <class Of> double overAzimuths(const std::optional<double>& azimuth, int count, const Of& of)
{
    if (azimuth)
        return of(*azimuth);
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
        sum += of(pi * (i + 0.5) / count); // turned by pi the grooves are the same
    return sum / count;
}

} // namespace

double GrooveTheory::once(const DirectionPair& directions) const
{
    return overAzimuths(azimuth, 20000, [&](double turned) {
        const Walls walls(slope, turned);
        return onceFrom(walls.left, directions) + onceFrom(walls.right, directions);
    });
}

double GrooveTheory::twice(const DirectionPair& directions) const
{
    return overAzimuths(azimuth, 180, [&](double turned) {
        const Walls walls(slope, turned);
        return twiceFrom(walls.left, walls.right, slope, directions) +
               twiceFrom(walls.right, walls.left, slope, directions);
    });
}

} // namespace reflectance
