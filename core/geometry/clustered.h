// A mesh with fewer triangles that looks alike from afar.
#pragma once

#include "core/geometry/mesh.h"

#include <cstddef>

namespace reflectance {

/// Vertices that lie in one cell of a grid, and whose normals leave a cube through one face, become one, at their mean; triangles
/// that lose a corner go. As fine as it can be with at most `mostTriangles`. After Rossignac & Borrel, Multi-resolution 3D
/// approximations for rendering complex scenes, 1993; the faces keep both sides of a thin wall and sharp edges apart. A
/// mesh that is small enough stays as it is, but for what belongs to its file.
[[nodiscard]] Mesh clustered(const Mesh& mesh, std::size_t mostTriangles);

} // namespace reflectance
