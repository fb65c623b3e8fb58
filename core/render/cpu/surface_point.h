// Where a ray meets a triangle, and the shading normal there: in double, from the mesh itself.
#pragma once

#include "core/geometry/mesh.h"

#include <cstdint>

namespace reflectance {

struct SurfacePoint {
    Vec3d P; ///< on the triangle
    Vec3d N; ///< unit; the vertex normals interpolated, turned to the side that the ray comes from
};

/// Möller & Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997. Where the double ray passes just outside
/// a triangle that the float ray met, the nearest barycentrics inside stand in. Vertex normals that cancel give way to
/// the triangle's own normal (hazard H14).
[[nodiscard]] SurfacePoint surfacePoint(const Mesh& mesh, std::uint32_t triangle, const Vec3d& eye,
                                        const Vec3d& direction);

} // namespace reflectance
