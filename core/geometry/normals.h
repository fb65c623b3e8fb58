// One unit normal for every corner of every triangle: the file's where it gives a usable one, otherwise smoothed over
// the faces around the vertex up to creases.
//
// This works on flat arrays rather than on the half-edge structure of topology.h: building that takes longer than all
// the smoothing, and it cannot hold edges with three triangles, which
// must be shaded all the same.
#pragma once

#include "core/geometry/triangle_list.h"

namespace reflectance {

/// The normals of every triangle's corners, those that corners share held once.
struct CornerNormals {
    std::vector<Vec3d> normals;          ///< unit
    std::vector<Mesh::Triangle> corners; ///< of each triangle, into `normals`; PolygonSoup::none where one is missing;
                                         ///< empty where `isOfVertex`, or where every one is missing
    bool isOfVertex = false;             ///< every corner has the normal of its vertex's number

    [[nodiscard]] bool areAllMissing() const { return corners.empty() && !isOfVertex; }
};

/// The file's normals, unit; missing where there is none or a bad one (hazard H13). A triangle that all of its
/// normals see from behind is turned over in `list`. Counts all of it in the report. Takes the soup's normals and the
/// list's indices of them.
[[nodiscard]] CornerNormals fileNormals(PolygonSoup& soup, TriangleList& list, MeshReport& report, int threads = 1);

/// Computes every normal that is missing. Faces around a vertex belong together where they share an edge at which
/// they bend by at most the crease angle; within such a fan the face normals are summed, weighted by the angle of the
/// face at the vertex (Thuermer and Wuethrich 1998), which makes the result independent of the triangulation. Vertices
/// at the same position count as one, so that seams between split vertices stay smooth. Where the sum cancels, the
/// face's own normal is used (hazard H14).
void smoothMissingNormals(const PolygonSoup& soup, const TriangleList& list, double creaseAngleDegrees,
                          CornerNormals& normals, MeshReport& report, int threads = 1);

} // namespace reflectance
