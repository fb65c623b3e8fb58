// The loops of lane_work.h in lanes B of doubles. Included by the lane_work_<set>.cpp only, each compiled for its own
// processor; nothing here may be called elsewhere.
#pragma once

#include "core/math/lanes.h"
#include "core/render/cpu/lane_work.h"
#include "core/render/cpu/surface_formula.h"
#include "core/render/cpu/surface_point.h"

#include <limits>
#include <utility>

namespace reflectance {

template <class B> Vec3<B> everywhere(const Vec3d& v)
{
    return {B(v.x), B(v.y), B(v.z)};
}

/// Unit directions through image points: PixelRays::through. `above` is the image point's height over the middle, at
/// distance 1. Their squares are finite and from 1 on, for `back` is unit and at right angles to the rest.
template <class B> Vec3<B> directionsAt(const PixelRays::Frame& frame, const B& x, const B& y)
{
    const B across = (x - B(frame.middleX)) * B(frame.scale);
    const B above = (B(frame.middleY) - y) * B(frame.scale);
    const Vec3<B> d = across * everywhere<B>(frame.right) + above * everywhere<B>(frame.up) - everywhere<B>(frame.back);
    return d / xsimd::sqrt(dot(d, d));
}

/// A packet's numbers before they are rounded.
template <class B> struct WidePacket {
    alignas(64) double numbers[7][16];

    void set(std::size_t first, const Vec3<B>& origin, const Vec3<B>& direction, const B& valid)
    {
        std::size_t i = 0;
        for (const B& number : {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, valid})
            number.store_aligned(&numbers[i++][first]);
    }
};

template <class B>
bool aim(const PixelRays::Frame& frame, double radius, const double* xs, const double* ys, int rows,
         const RayColumns& rays)
{
    WidePacket<B> packet;
    const Vec3<B> eye = everywhere<B>(frame.eye);
    const B reach(1.001 * radius);
    const B zero(0.0);
    bool any = false;
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
        for (std::size_t column = 0; column < 4; column += B::size) {
            const Vec3<B> direction = directionsAt(frame, B::load_unaligned(xs + column), B(ys[row]));
            const B nearest = -dot(eye, direction);
            const Vec3<B> foot = eye + nearest * direction;
            const auto valid = nearest > -reach && dot(foot, foot) < reach * reach;
            const B start = choose(nearest - reach > zero, nearest - reach, zero);
            packet.set(4 * row + column, eye + start * direction, direction, choose(valid, B(-1.0), zero));
            any = any || xsimd::any(valid);
        }
    const std::size_t count = static_cast<std::size_t>(rows) * 4;
    for (std::size_t i = 0; i < count; ++i)
        rays.valid[i] = static_cast<int>(packet.numbers[6][i]);
    if (!any)
        return false;
    float* const columns[] = {rays.originX,    rays.originY,    rays.originZ,
                              rays.directionX, rays.directionY, rays.directionZ};
    for (std::size_t number = 0; number < 6; ++number)
        for (std::size_t i = 0; i < count; ++i)
            columns[number][i] = static_cast<float>(packet.numbers[number][i]);
    return true;
}

template <class B, std::size_t... lane>
Vec3<B> gathered(const Vec3d* from, const std::uint32_t* const* corners, std::size_t corner,
                 std::index_sequence<lane...>)
{
    return {B{from[corners[lane][corner]].x...}, B{from[corners[lane][corner]].y...},
            B{from[corners[lane][corner]].z...}};
}

/// The mesh's arrays, as plain pointers.
struct Corners {
    const Vec3d* positions;
    const Vec3d* normals;
    const Mesh::Triangle* triangles;
};

template <class B> struct FoundPoints {
    Vec3<B> P, N;
    bool usual; ///< false: one of the lanes is a case that surfacePoint has to look at
};

template <class B>
FoundPoints<B> foundPoints(const Corners& mesh, const Vec3<B>& eye, const Vec3<B>& direction, const std::uint32_t* met)
{
    constexpr auto lanes = std::make_index_sequence<B::size>();
    const std::uint32_t* corners[B::size];
    for (std::size_t i = 0; i < B::size; ++i)
        corners[i] = mesh.triangles[met[i]].data();
    const Vec3<B> A = gathered<B>(mesh.positions, corners, 0, lanes);
    const Span<B> span{A, gathered<B>(mesh.positions, corners, 1, lanes) - A,
                       gathered<B>(mesh.positions, corners, 2, lanes) - A};
    const Barycentrics<B> plane = crossing(span, eye, direction);
    const Barycentrics<B> at = insideTriangle(plane);
    const Vec3<B> N =
        normalAt(gathered<B>(mesh.normals, corners, 0, lanes), gathered<B>(mesh.normals, corners, 1, lanes),
                 gathered<B>(mesh.normals, corners, 2, lanes), at);
    const B squared = dot(N, N);
    const B infinity(std::numeric_limits<double>::infinity());
    // The range in which normalized() divides by the length, and the finite u and v: comparisons with NaN are false.
    const auto usual =
        squared > B(1e-200) && squared < B(1e200) && xsimd::abs(plane.u) < infinity && xsimd::abs(plane.v) < infinity;
    const Vec3<B> unit = N / xsimd::sqrt(squared);
    const auto away = dot(cross(span.edge1, span.edge2), direction) > B(0.0);
    return {positionAt(span, at),
            {choose(away, -unit.x, unit.x), choose(away, -unit.y, unit.y), choose(away, -unit.z, unit.z)},
            xsimd::all(usual)};
}

template <class B> void store(const Vec3<B>& v, double* x, double* y, double* z)
{
    v.x.store_unaligned(x);
    v.y.store_unaligned(y);
    v.z.store_unaligned(z);
}

/// One register of samples, all of them.
template <class B>
void findRegister(const Mesh& whole, const Corners& mesh, const PixelRays::Frame& frame, const MetColumns& met,
                  std::size_t i, const PointColumns& to)
{
    const Vec3<B> direction = directionsAt(frame, B::load_unaligned(met.x + i), B::load_unaligned(met.y + i));
    const auto found = foundPoints(mesh, everywhere<B>(frame.eye), direction, met.triangle + i);
    store(found.P, to.Px + i, to.Py + i, to.Pz + i);
    store(found.N, to.Nx + i, to.Ny + i, to.Nz + i);
    if (found.usual)
        return;
    alignas(64) double d[3][B::size];
    store(direction, d[0], d[1], d[2]);
    for (std::size_t lane = 0; lane < B::size; ++lane) {
        const SurfacePoint point =
            surfacePoint(whole, met.triangle[i + lane], frame.eye, {d[0][lane], d[1][lane], d[2][lane]});
        to.Px[i + lane] = point.P.x;
        to.Py[i + lane] = point.P.y;
        to.Pz[i + lane] = point.P.z;
        to.Nx[i + lane] = point.N.x;
        to.Ny[i + lane] = point.N.y;
        to.Nz[i + lane] = point.N.z;
    }
}

/// The samples that do not fill a register: the last one fills it up.
template <class B>
void findRest(const Mesh& whole, const Corners& mesh, const PixelRays::Frame& frame, const MetColumns& met,
              std::size_t first, const PointColumns& to)
{
    double x[B::size], y[B::size];
    std::uint32_t triangle[B::size];
    double points[6][B::size];
    for (std::size_t lane = 0; lane < B::size; ++lane) {
        const std::size_t i = first + lane < met.count ? first + lane : met.count - 1;
        x[lane] = met.x[i];
        y[lane] = met.y[i];
        triangle[lane] = met.triangle[i];
    }
    findRegister<B>(whole, mesh, frame, {B::size, x, y, triangle}, 0,
                    {points[0], points[1], points[2], points[3], points[4], points[5]});
    double* const columns[] = {to.Px, to.Py, to.Pz, to.Nx, to.Ny, to.Nz};
    for (std::size_t number = 0; number < 6; ++number)
        for (std::size_t i = first; i < met.count; ++i)
            columns[number][i] = points[number][i - first];
}

template <class B>
void find(const Mesh& whole, const PixelRays::Frame& frame, const MetColumns& met, const PointColumns& to)
{
    const Corners mesh{whole.positions.data(), whole.normals.data(), whole.triangles.data()};
    std::size_t i = 0;
    for (; i + B::size <= met.count; i += B::size)
        findRegister<B>(whole, mesh, frame, met, i, to);
    if (i < met.count)
        findRest<B>(whole, mesh, frame, met, i, to);
}

template <class B> constexpr LaneWork makeLaneWork()
{
    return {aim<B>, find<B>};
}

} // namespace reflectance
