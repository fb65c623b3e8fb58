// Martin Newell's teapot (1975): his published control points, tessellated here. The body, lid and bottom are quarter
// turns of a few profile curves, handle and spout are mirrored about the plane y = 0; all of it bicubic Bezier patches.
#include "tools/meshes/stock.h"

#include <array>

namespace reflectance::stock {
namespace {

/// Control points, row by row; Newell's z points up.
using Patch = std::array<std::array<Vec3d, 4>, 4>;

/// The control points (radius, height) of one profile curve.
using Profile = std::array<std::array<double, 2>, 4>;

constexpr int steps = 12; ///< pieces along each side of a patch

constexpr std::array<Profile, 6> profiles{{
    {{{0.0, 3.15}, {0.8, 3.15}, {0.0, 2.85}, {0.2, 2.7}}},            // knob
    {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}},             // lid
    {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}}, // rim
    {{{1.5, 2.4}, {1.75, 1.875}, {2.0, 1.35}, {2.0, 0.9}}},           // upper body
    {{{2.0, 0.9}, {2.0, 0.45}, {1.5, 0.225}, {1.5, 0.15}}},           // lower body
    {{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0.0}, {0.0, 0.0}}},          // bottom
}};

constexpr Patch upperHandle{{{Vec3d{-1.6, 0, 2.025}, {-1.6, -0.3, 2.025}, {-1.5, -0.3, 2.25}, {-1.5, 0, 2.25}},
                             {Vec3d{-2.3, 0, 2.025}, {-2.3, -0.3, 2.025}, {-2.5, -0.3, 2.25}, {-2.5, 0, 2.25}},
                             {Vec3d{-2.7, 0, 2.025}, {-2.7, -0.3, 2.025}, {-3.0, -0.3, 2.25}, {-3.0, 0, 2.25}},
                             {Vec3d{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3.0, -0.3, 1.8}, {-3.0, 0, 1.8}}}};

constexpr Patch lowerHandle{{{Vec3d{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3.0, -0.3, 1.8}, {-3.0, 0, 1.8}},
                             {Vec3d{-2.7, 0, 1.575}, {-2.7, -0.3, 1.575}, {-3.0, -0.3, 1.35}, {-3.0, 0, 1.35}},
                             {Vec3d{-2.5, 0, 1.125}, {-2.5, -0.3, 1.125}, {-2.65, -0.3, 0.9375}, {-2.65, 0, 0.9375}},
                             {Vec3d{-2.0, 0, 0.9}, {-2.0, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0, 0.6}}}};

constexpr Patch lowerSpout{{{Vec3d{1.7, 0, 1.425}, {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0, 0.6}},
                            {Vec3d{2.6, 0, 1.425}, {2.6, -0.66, 1.425}, {3.1, -0.66, 0.825}, {3.1, 0, 0.825}},
                            {Vec3d{2.3, 0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025}, {2.4, 0, 2.025}},
                            {Vec3d{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}}};

constexpr Patch upperSpout{{{Vec3d{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}},
                            {Vec3d{2.8, 0, 2.475}, {2.8, -0.25, 2.475}, {3.525, -0.25, 2.49375}, {3.525, 0, 2.49375}},
                            {Vec3d{2.9, 0, 2.475}, {2.9, -0.15, 2.475}, {3.45, -0.15, 2.5125}, {3.45, 0, 2.5125}},
                            {Vec3d{2.8, 0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0, 2.4}}}};

/// A quarter turn of a profile. Newell's quarter circle has its inner control points at 0.56 of the radius.
Patch quarterTurn(const Profile& profile, int quarter)
{
    static constexpr double directions[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    static constexpr double shares[4][2] = {{1, 0}, {1, 0.56}, {0.56, 1}, {0, 1}};
    const double* const from = directions[quarter];
    const double* const to = directions[(quarter + 1) % 4];
    Patch patch;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const double radius = profile[i][0];
            patch[i][j] = {radius * (shares[j][0] * from[0] + shares[j][1] * to[0]),
                           radius * (shares[j][0] * from[1] + shares[j][1] * to[1]), profile[i][1]};
        }
    return patch;
}

Patch mirrored(const Patch& patch)
{
    Patch result = patch;
    for (auto& row : result)
        for (Vec3d& p : row)
            p.y = -p.y;
    return result;
}

std::array<double, 4> weights(double t)
{
    const double s = 1.0 - t;
    return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

std::array<double, 4> slopes(double t)
{
    const double s = 1.0 - t;
    return {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t};
}

Vec3d blend(const Patch& patch, const std::array<double, 4>& u, const std::array<double, 4>& v)
{
    Vec3d sum;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            sum += u[i] * v[j] * patch[i][j];
    return sum;
}

/// `side` says which of the two normals points outward.
SurfacePoint pointOf(const Patch& patch, double u, double v, double side)
{
    const Vec3d p = blend(patch, weights(u), weights(v));
    Vec3d normal = normalized(cross(blend(patch, slopes(u), weights(v)), blend(patch, weights(u), slopes(v))));
    if (normal == Vec3d()) // the poles of knob and bottom, where the patch has no width
        normal = {0.0, 0.0, side * (p.z > 1.0 ? 1.0 : -1.0)};
    return {{p.x, p.z, -p.y}, side * Vec3d{normal.x, normal.z, -normal.y}};
}

} // namespace

Shape teapot()
{
    Shape shape;
    const auto point = [](int i, int pieces) { return static_cast<double>(i) / pieces; };
    for (const Profile& profile : profiles)
        addGrid(shape, {steps + 1, 4 * steps, false, true}, [&](int row, int column) {
            return pointOf(quarterTurn(profile, column / steps), point(row, steps), point(column % steps, steps), 1.0);
        });
    for (const Patch* patch : {&upperHandle, &lowerHandle, &lowerSpout, &upperSpout})
        addGrid(shape, {steps + 1, 2 * steps, false, true}, [&](int row, int column) {
            const double v = point(column % steps, steps);
            return column < steps ? pointOf(*patch, point(row, steps), v, -1.0)
                                  : pointOf(mirrored(*patch), point(row, steps), 1.0 - v, 1.0);
        });
    return shape;
}

} // namespace reflectance::stock
