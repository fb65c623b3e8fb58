// How much memory a mesh takes.
#pragma once

#include "core/geometry/mesh.h"

#include <cstddef>

namespace reflectance {

/// Of its arrays, in bytes.
[[nodiscard]] inline std::size_t bytesOf(const Mesh& mesh)
{
    return sizeof(Vec3d) * (mesh.positions.size() + mesh.normals.size()) +
           sizeof(std::uint32_t) * mesh.fileVertex.size() + sizeof(Mesh::Triangle) * mesh.triangles.size();
}

} // namespace reflectance
