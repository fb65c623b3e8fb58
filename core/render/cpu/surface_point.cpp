#include "core/render/cpu/surface_point.h"

#include "core/render/cpu/surface_formula.h"

namespace reflectance {

SurfacePoint surfacePoint(const Mesh& mesh, std::uint32_t triangle, const Vec3d& eye, const Vec3d& direction)
{
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec3d& A = mesh.positions[a];
    const Span<double> span{A, mesh.positions[b] - A, mesh.positions[c] - A};
    Barycentrics<double> at = crossing(span, eye, direction);
    at = std::isfinite(at.u) && std::isfinite(at.v) ? insideTriangle(at) : Barycentrics<double>{1.0 / 3.0, 1.0 / 3.0};

    const Vec3d geometric = cross(span.edge1, span.edge2);
    Vec3d N = normalized(normalAt(mesh.normals[a], mesh.normals[b], mesh.normals[c], at));
    if (N == Vec3d())
        N = normalized(geometric);
    return {positionAt(span, at), dot(geometric, direction) > 0.0 ? -N : N};
}

} // namespace reflectance
