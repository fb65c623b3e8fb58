// From checked triangles and their corner normals to the Mesh that is drawn.
#pragma once

#include "core/geometry/normals.h"

namespace reflectance {

/// Centred and scaled in double, vertices split where normals differ. Fills the report's vertex counts, area, bounds.
/// The list's triangles become the mesh's in their place.
[[nodiscard]] Mesh assembled(const PolygonSoup& soup, TriangleList list, const CornerNormals& normals,
                             MeshReport& report, int threads = 1);

} // namespace reflectance
