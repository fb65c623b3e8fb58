// The faces that can be drawn, as triangles over the file's vertices: what remains of a polygon soup once faces that
// cannot be drawn have been counted and left out.
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/polygon_soup.h"
#include "core/geometry/readers.h"
#include "core/geometry/report.h"
#include "core/geometry/unfilled.h"

namespace reflectance {

struct TriangleList {
    std::vector<Mesh::Triangle> vertices; ///< into PolygonSoup::positions; every one finite
    std::vector<Mesh::Triangle> normals;  ///< into PolygonSoup::normals or `none`; empty where the file names none
    bool normalOfVertex = false;          ///< every corner's normal has its vertex's number: `normals` stays empty
    UnfilledVector<Vec3d> faceNormals;    ///< unit, by the winding

    [[nodiscard]] bool namesNormals() const { return normalOfVertex || !normals.empty(); }
};

/// Unit normal by the winding, computed from the file's own coordinates so that a tiny triangle keeps its direction;
/// (0,0,0) where the area is zero to within the rounding of the coordinates. Hazard H15.
[[nodiscard]] Vec3d faceNormal(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// Checks every face, triangulates and leaves out what has no area. Fills the report's counts of faces, dropped faces,
/// degenerate triangles and triangles. Takes the faces out of the soup: of a large mesh no two copies are held.
Result<TriangleList> trianglesOf(PolygonSoup& soup, ReadContext& context, MeshReport& report);

} // namespace reflectance
