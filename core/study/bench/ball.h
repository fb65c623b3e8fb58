// A sphere of any number of triangles, to load and to draw.
#pragma once

#include "core/geometry/mesh.h"

#include <memory>
#include <string>

namespace reflectance {

/// About `triangles` of them: rings of quadrilaterals, halved; smooth normals.
[[nodiscard]] std::shared_ptr<const Mesh> ball(std::size_t triangles);

/// As a file: OBJ with normals, and binary PLY.
[[nodiscard]] std::string objOf(const Mesh& mesh);
[[nodiscard]] std::string plyOf(const Mesh& mesh);

} // namespace reflectance
