// A thrown clay mug: a revolved body with wall, lip and foot, and a pulled handle that flows into it. Centimetres.
#include "tools/meshes/stock.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace reflectance::stock {
namespace {

constexpr int bodySegments = 108;
constexpr int handleSegments = 32;
constexpr double filletRadius = 0.75; ///< of the transition from handle to wall

/// From the middle of the underside over the foot, the wall and the lip to the middle of the inside.
std::vector<ProfilePoint> bodyProfile()
{
    return roundedProfile({{0.0, 0.42, 0.0},
                           {2.45, 0.42, 0.20},
                           {2.62, 0.0, 0.10},
                           {3.02, 0.0, 0.14},
                           {3.22, 0.50, 0.20},
                           {3.86, 0.98, 0.95},
                           {4.12, 5.2, 30.0},
                           {4.16, 9.6, 0.19},
                           {3.76, 9.6, 0.19},
                           {3.72, 5.2, 30.0},
                           {3.50, 0.95, 1.35},
                           {0.0, 0.80, 0.0}},
                          12.0, 1.0);
}

/// The outer wall at a height between foot and lip.
ProfilePoint wallAt(const std::vector<ProfilePoint>& profile, double height)
{
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const ProfilePoint& a = profile[i - 1];
        const ProfilePoint& b = profile[i];
        if (a.radius > 3.5 && a.height <= height && height <= b.height && b.height > a.height) {
            const double t = (height - a.height) / (b.height - a.height);
            const auto mixed = [t](double from, double to) { return from + t * (to - from); };
            return {mixed(a.radius, b.radius), height, mixed(a.normalRadius, b.normalRadius),
                    mixed(a.normalHeight, b.normalHeight)};
        }
    }
    return profile.front();
}

Vec3d bezier(const std::array<Vec3d, 4>& p, double t)
{
    const double s = 1.0 - t;
    return s * s * s * p[0] + 3.0 * s * s * t * p[1] + 3.0 * s * t * t * p[2] + t * t * t * p[3];
}

/// The middle line of the handle, t = 0 at the upper end and 1 at the lower, both within the wall.
Vec3d handleLine(double t)
{
    static constexpr std::array<Vec3d, 4> upper{Vec3d{3.9, 7.55, 0}, {5.75, 8.3, 0}, {7.2, 8.1, 0}, {7.3, 6.0, 0}};
    static constexpr std::array<Vec3d, 4> lower{Vec3d{7.3, 6.0, 0}, {7.38, 4.25, 0}, {6.0, 3.35, 0}, {3.85, 2.3, 0}};
    return t < 0.5 ? bezier(upper, 2.0 * t) : bezier(lower, 2.0 * t - 1.0);
}

/// Where along the handle the rings lie: closer together in the fillets.
std::vector<double> ringPlaces(const std::vector<ProfilePoint>& profile)
{
    const auto outside = [&](double t) { return handleLine(t).x - wallAt(profile, handleLine(t).y).radius; };
    const auto placeAt = [&](double distance, double inside, double beyond) {
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (inside + beyond);
            (outside(middle) < distance ? inside : beyond) = middle;
        }
        return inside;
    };
    constexpr int filletRings = 10;
    constexpr int middleRings = 34;
    std::vector<double> places;
    for (int i = 0; i <= filletRings; ++i)
        places.push_back(placeAt(filletRadius * i * i / (filletRings * filletRings), 0.0, 0.3));
    const double first = places.back();
    const double last = placeAt(filletRadius, 1.0, 0.7);
    for (int i = 1; i < middleRings; ++i)
        places.push_back(first + (last - first) * i / middleRings);
    for (int i = filletRings; i >= 0; --i)
        places.push_back(placeAt(filletRadius * i * i / (filletRings * filletRings), 1.0, 0.7));
    return places;
}

/// How much wider the section is at this distance from the wall: a quarter circle, tangent to the wall.
double flare(double distance)
{
    const double left = std::clamp(filletRadius - distance, 0.0, filletRadius);
    return filletRadius - std::sqrt(filletRadius * filletRadius - left * left);
}

/// A point of the handle and how far it has become wall (0 free, 1 wall).
struct HandlePoint {
    Vec3d position;
    double wallness;
};

HandlePoint handlePoint(const std::vector<ProfilePoint>& profile, double t, double angle)
{
    const Vec3d middle = handleLine(t);
    const Vec3d along = normalized(handleLine(t + 1e-4) - handleLine(t - 1e-4));
    const Vec3d out{along.y, -along.x, 0.0};
    const double distance = std::max(middle.x - wallAt(profile, middle.y).radius, 0.0);
    const double wider = flare(distance);
    const double thickness = 0.40 - 0.06 * t + wider;
    const double width = 0.70 - 0.10 * t + 0.9 * wider;
    // A superellipse: a strap with soft edges rather than a tube.
    const auto soft = [](double c) { return std::copysign(std::pow(std::fabs(c), 0.86), c); };
    Vec3d p = middle + thickness * soft(std::cos(angle)) * out + Vec3d(0.0, 0.0, width * soft(std::sin(angle)));
    // Towards its end the ring lies ever more on the round wall; a hair deeper, so that no gap can show.
    const double near = 1.0 - std::min(distance / filletRadius, 1.0);
    const double wallness = near * near * (3.0 - 2.0 * near);
    const double radius = std::hypot(p.x, p.z);
    const double wanted = radius + wallness * (wallAt(profile, p.y).radius + distance - 0.02 - radius);
    p.x *= wanted / radius;
    p.z *= wanted / radius;
    return {p, wallness};
}

void addHandle(Shape& shape, const std::vector<ProfilePoint>& profile)
{
    const std::vector<double> places = ringPlaces(profile);
    const GridSize size{static_cast<int>(places.size()), handleSegments, false, true};
    std::vector<Vec3d> positions;
    std::vector<double> wallness;
    for (const double t : places)
        for (int i = 0; i < handleSegments; ++i) {
            const HandlePoint p = handlePoint(profile, t, 2.0 * std::numbers::pi * i / handleSegments);
            positions.push_back(p.position);
            wallness.push_back(p.wallness);
        }
    const auto outward = [&](std::size_t i) {
        Vec3d middle;
        for (std::size_t k = 0; k < handleSegments; ++k)
            middle += positions[i / handleSegments * handleSegments + k] / static_cast<double>(handleSegments);
        return positions[i] - middle;
    };
    std::vector<SurfacePoint> points = withNormals(size, positions, [&](const Vec3d& p) {
        return outward(static_cast<std::size_t>(std::find(positions.begin(), positions.end(), p) - positions.begin()));
    });
    // Where handle meets wall both have the wall's normal, so that no line shows.
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3d& p = points[i].position;
        const ProfilePoint wall = wallAt(profile, p.y);
        const double radius = std::hypot(p.x, p.z);
        const Vec3d normal =
            normalized(Vec3d{wall.normalRadius * p.x / radius, wall.normalHeight, wall.normalRadius * p.z / radius});
        const double share = std::pow(wallness[i], 12.0);
        points[i].normal = normalized((1.0 - share) * points[i].normal + share * normal);
    }
    addGrid(shape, size, [&](int row, int column) {
        return points[static_cast<std::size_t>(row) * std::size_t{handleSegments} + static_cast<std::size_t>(column)];
    });
}

} // namespace

Shape mug()
{
    Shape shape;
    const std::vector<ProfilePoint> profile = bodyProfile();
    addRevolved(shape, profile, bodySegments);
    addHandle(shape, profile);
    return shape;
}

} // namespace reflectance::stock
