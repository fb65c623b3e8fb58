// A bumpy torus knot of any number of triangles: the mesh of all measurements here.
#pragma once

#include "core/geometry/mesh.h"

#include <cstdint>
#include <memory>
#include <string>

namespace reflectance::bench {

enum class KnotNormals { None, InFile };

/// As OBJ, 6 decimals: v, vn and f a//a b//b c//c, or v and f a b c. Some `triangles` of them, at least 8.
[[nodiscard]] std::string knotObj(std::int64_t triangles, KnotNormals normals);

/// As binary little-endian PLY: float positions and int indices.
[[nodiscard]] std::string knotPly(std::int64_t triangles);

/// The path of a file in the temporary folder that holds the knot; written when first asked for.
[[nodiscard]] std::string knotFile(std::int64_t triangles, KnotNormals normals);

[[nodiscard]] std::shared_ptr<const Mesh> knotMesh(std::int64_t triangles);

} // namespace reflectance::bench
