// Simple shapes with known normals: each shows one thing about shading well.
#include "tools/meshes/stock.h"

#include <array>
#include <numbers>

namespace reflectance::stock {
namespace {

constexpr double pi = std::numbers::pi;

/// A (2,3) torus knot about the y axis.
Vec3d knotLine(double t)
{
    const double radius = 2.0 + 0.85 * std::cos(3.0 * t);
    return {radius * std::cos(2.0 * t), 0.95 * std::sin(3.0 * t), radius * std::sin(2.0 * t)};
}

} // namespace

/// Unit sphere by longitude and latitude: the reference shape, its normal equals its position.
Shape sphere()
{
    constexpr int rows = 65;
    constexpr int columns = 128;
    Shape shape;
    addGrid(shape, {rows, columns, false, true}, [](int row, int column) {
        const double latitude = pi * row / (rows - 1);
        const double longitude = 2.0 * pi * column / columns;
        const bool isPole = row == 0 || row == rows - 1;
        const double radius = isPole ? 0.0 : std::sin(latitude);
        const Vec3d p{radius * std::cos(longitude), std::cos(latitude), -radius * std::sin(longitude)};
        return SurfacePoint{p, normalized(p)};
    });
    return shape;
}

/// A tube along a knot: every direction of normal many times, with self-occlusion.
Shape torusKnot()
{
    constexpr int rows = 300;
    constexpr int columns = 28;
    static constexpr double tube = 0.46;
    Shape shape;
    addGrid(shape, {rows, columns, true, true}, [](int row, int column) {
        const double t = 2.0 * pi * row / rows;
        const double angle = 2.0 * pi * column / columns;
        const Vec3d middle = knotLine(t);
        const Vec3d along = normalized(knotLine(t + 1e-4) - knotLine(t - 1e-4));
        // The direction to the axis of the torus turns smoothly along the knot: the tube closes without a twist.
        const Vec3d out{std::cos(2.0 * t), 0.0, std::sin(2.0 * t)};
        const Vec3d side = normalized(cross(along, out));
        const Vec3d normal = std::cos(angle) * cross(side, along) + std::sin(angle) * side;
        return SurfacePoint{middle + tube * normal, normal};
    });
    return shape;
}

/// A cube of edge 2 whose faces keep their own normals: hard edges.
Shape cube()
{
    constexpr int points = 9;
    static constexpr std::array<Vec3d, 6> normals{Vec3d{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},
                                                  {0, -1, 0},     {0, 0, 1},  {0, 0, -1}};
    Shape shape;
    for (const Vec3d& normal : normals) {
        const Vec3d u{normal.z, normal.x, normal.y};
        const Vec3d w = cross(normal, u);
        addGrid(shape, {points, points, false, false}, [&](int row, int column) {
            const double a = 2.0 * row / (points - 1) - 1.0;
            const double b = 2.0 * column / (points - 1) - 1.0;
            return SurfacePoint{normal + a * u + b * w, normal};
        });
    }
    return shape;
}

/// y = 0.16 sin(3x) cos(3z) + 0.04 sin(7x + 2z) over a square: highlights that stretch, split and merge.
Shape wavyPlane()
{
    constexpr int points = 96;
    Shape shape;
    addGrid(shape, {points, points, false, false}, [](int row, int column) {
        const double x = 4.0 * row / (points - 1) - 2.0;
        const double z = 4.0 * column / (points - 1) - 2.0;
        const double y = 0.16 * std::sin(3.0 * x) * std::cos(3.0 * z) + 0.04 * std::sin(7.0 * x + 2.0 * z);
        const double dx = 0.48 * std::cos(3.0 * x) * std::cos(3.0 * z) + 0.28 * std::cos(7.0 * x + 2.0 * z);
        const double dz = -0.48 * std::sin(3.0 * x) * std::sin(3.0 * z) + 0.08 * std::cos(7.0 * x + 2.0 * z);
        return SurfacePoint{{x, y, z}, normalized(Vec3d{-dx, 1.0, -dz})};
    });
    return shape;
}

/// A thrown vase with a wall, a narrow neck and a flared lip.
Shape vase()
{
    Shape shape;
    addRevolved(shape,
                roundedProfile({{0.0, 0.30, 0.0},
                                {1.75, 0.30, 0.15},
                                {1.90, 0.0, 0.09},
                                {2.25, 0.0, 0.16},
                                {4.9, 5.2, 4.2},
                                {1.45, 9.2, 2.4},
                                {1.40, 11.0, 1.6},
                                {2.75, 12.6, 0.14},
                                {2.45, 12.85, 0.14},
                                {1.08, 11.1, 1.6},
                                {1.12, 9.05, 2.0},
                                {4.45, 5.2, 3.8},
                                {1.95, 0.55, 1.3},
                                {0.0, 0.60, 0.0}},
                               8.0, 1.0),
                84);
    return shape;
}

} // namespace reflectance::stock
