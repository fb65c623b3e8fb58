// One part of an OBJ file, read without knowing what stands before it.
#pragma once

#include "core/geometry/polygon_soup.h"
#include "core/geometry/warnings.h"

#include <string_view>

namespace reflectance {

/// An index that counts back from the newest vertex or normal, while it is unknown how many stood before the part.
struct RelativeIndex {
    std::size_t corner;     ///< of the part
    long long fromPartZero; ///< zero-based, counted from the part's first vertex or normal; below 0 before the part
};

/// Lines and vertices are counted from the part's beginning, faces as in PolygonSoup.
struct ObjPart {
    std::vector<Vec3d> positions, normals;
    std::vector<PolygonSoup::Index> corners;
    std::vector<PolygonSoup::Index> cornerNormals; ///< of all corners, or of none where no face names a normal
    std::vector<PolygonSoup::Index> faceEnds;      ///< empty where all faces have three corners
    std::vector<PolygonSoup::Index> faceLines;
    std::vector<RelativeIndex> relativeCorners, relativeNormals;
    Warnings warnings;
    long lines = 0; ///< line breaks
    bool hasMaterials = false;

    /// Makes it empty; its memory is kept.
    void clear();
};

/// Reads a part that begins and ends where a line does. `part` is empty before.
void readObjPart(std::string_view text, ObjPart& part);

} // namespace reflectance
