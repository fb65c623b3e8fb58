// One unit normal for every corner of every triangle: the file's where it gives a usable one, otherwise smoothed over
// the faces around the vertex up to creases.
//
// This works on flat arrays rather than on the half-edge structure of topology.h: building that takes longer than all
// the smoothing (0.8 s against 0.6 s for a million triangles), and it cannot hold edges with three triangles, which
// must be shaded all the same.
#pragma once

#include "core/geometry/triangle_list.h"

namespace reflectance {

/// For each triangle, the normals of its three corners.
using CornerNormals = std::vector<std::array<Vec3d, 3>>;

/// The file's normals, unit; (0,0,0) where there is none or a bad one (hazard H13). A triangle that all of its
/// normals see from behind is turned over in `list`. Counts all of it in the report.
[[nodiscard]] CornerNormals fileNormals(const PolygonSoup& soup, TriangleList& list, MeshReport& report);

/// Computes every normal that is still (0,0,0). Faces around a vertex belong together where they share an edge at which
/// they bend by at most the crease angle; within such a fan the face normals are summed, weighted by the angle of the
/// face at the vertex (Thuermer and Wuethrich 1998), which makes the result independent of the triangulation. Vertices
/// at the same position count as one, so that seams between split vertices stay smooth. Where the sum cancels, the
/// face's own normal is used (hazard H14).
void smoothMissingNormals(const PolygonSoup& soup, const TriangleList& list, double creaseAngleDegrees,
                          CornerNormals& normals, MeshReport& report);

} // namespace reflectance
