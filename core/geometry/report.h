// What the reader found in a mesh file and what it did about it: the contents of `inspect`.
#pragma once

#include "core/math/vec.h"

#include <cstddef>
#include <string>
#include <vector>

namespace reflectance {

/// One finding, with its place in the file.
struct MeshWarning {
    std::string text;
    long line = 0; ///< 1-based; 0 where the file has no lines or no single line is meant
};

/// How many faces were left out for one reason.
struct DroppedFaces {
    std::string reason; ///< "uses a vertex that the file does not have"
    std::size_t count = 0;
};

struct MeshReport {
    std::string format;                  ///< "OBJ", "PLY (binary, little-endian)"
    std::size_t fileVertices = 0;        ///< as listed in the file (STL: distinct positions)
    std::size_t fileFaces = 0;           ///< polygons as listed in the file
    std::size_t triangles = 0;           ///< drawn
    std::size_t meshVertices = 0;        ///< drawn: file vertices split where normals differ
    std::size_t unusedVertices = 0;      ///< file vertices that no drawn triangle uses
    std::size_t degenerateTriangles = 0; ///< of zero area, left out; not counted as dropped faces

    double area = 0.0; ///< of the drawn triangles, in the file's units squared
    Vec3d lowest{};    ///< corner of the bounding box of the drawn triangles, in the file's units
    Vec3d highest{};

    std::vector<DroppedFaces> dropped;

    std::size_t cornersWithFileNormal = 0;     ///< triangle corners drawn with the file's normal
    std::size_t cornersWithoutNormal = 0;      ///< the file gave none
    std::size_t cornersWithBadNormal = 0;      ///< zero, not finite, or an index that does not exist
    std::size_t cornersWithComputedNormal = 0; ///< smoothed within the crease angle
    std::size_t flippedTriangles = 0;          ///< turned over, because their normals pointed against their winding

    double readSeconds = 0.0;
    double triangulateSeconds = 0.0;
    double normalsSeconds = 0.0;

    std::vector<MeshWarning> warnings; ///< repeated kinds: the first three, then one line that counts the rest
    std::vector<std::string> notes;    ///< worth knowing, nothing wrong

    [[nodiscard]] std::size_t droppedFaces() const;
};

} // namespace reflectance
