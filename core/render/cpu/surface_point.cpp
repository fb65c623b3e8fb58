#include "core/render/cpu/surface_point.h"

#include <algorithm>

namespace reflectance {
namespace {

struct Barycentrics {
    double u = 1.0 / 3.0, v = 1.0 / 3.0; ///< weights of the second and third vertex
};

Barycentrics insideTriangle(double u, double v)
{
    if (!std::isfinite(u) || !std::isfinite(v))
        return {}; // the ray runs in the triangle's plane
    u = std::max(u, 0.0);
    v = std::max(v, 0.0);
    const double sum = std::max(u + v, 1.0);
    return {u / sum, v / sum};
}

} // namespace

SurfacePoint surfacePoint(const Mesh& mesh, std::uint32_t triangle, const Vec3d& eye, const Vec3d& direction)
{
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec3d& A = mesh.positions[a];
    const Vec3d edge1 = mesh.positions[b] - A;
    const Vec3d edge2 = mesh.positions[c] - A;
    const Vec3d fromA = eye - A;
    const Vec3d p = cross(direction, edge2);
    const Vec3d q = cross(fromA, edge1);
    const double determinant = dot(edge1, p);
    const auto [u, v] = insideTriangle(dot(fromA, p) / determinant, dot(direction, q) / determinant);

    const Vec3d geometric = cross(edge1, edge2);
    Vec3d N = normalized((1.0 - u - v) * mesh.normals[a] + u * mesh.normals[b] + v * mesh.normals[c]);
    if (N == Vec3d())
        N = normalized(geometric);
    return {A + u * edge1 + v * edge2, dot(geometric, direction) > 0.0 ? -N : N};
}

} // namespace reflectance
