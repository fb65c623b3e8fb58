// What every mesh reader delivers: polygons as the file lists them, in double, nothing repaired yet.
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace reflectance {

/// Empties a vector and gives its memory back, which `= {}` would keep.
template <class Vector> void giveBack(Vector& vector)
{
    Vector().swap(vector);
}

struct PolygonSoup {
    using Index = std::uint32_t;

    /// An index that names nothing: absent in the file, or impossible.
    static constexpr Index none = std::numeric_limits<Index>::max();

    std::string format;               ///< "OBJ"
    std::vector<Vec3d> positions;     ///< may hold NaN: a damaged vertex keeps its place, so that no index shifts
    std::vector<Vec3d> normals;       ///< as listed, not necessarily unit
    std::vector<Index> corners;       ///< positions of all faces' corners, face after face; may be out of range
    std::vector<Index> cornerNormals; ///< into normals, one per corner; empty where no face names a normal
    bool normalOfVertex = false;      ///< every corner's normal has its position's number: cornerNormals stays empty
    std::vector<Index> faceEnds;      ///< corners of face i end before faceEnds[i]; empty where all have three
    std::vector<Index> faceLines;     ///< line of each face; empty for binary files
    std::vector<std::string> notes;   ///< "materials are ignored"

    [[nodiscard]] bool namesNormals() const { return normalOfVertex || !cornerNormals.empty(); }
    [[nodiscard]] Index normalAt(std::size_t corner) const
    {
        return normalOfVertex ? corners[corner] : cornerNormals[corner];
    }

    [[nodiscard]] std::size_t faceCount() const { return faceEnds.empty() ? corners.size() / 3 : faceEnds.size(); }
    [[nodiscard]] Index faceEnd(std::size_t face) const
    {
        return faceEnds.empty() ? static_cast<Index>(3 * face + 3) : faceEnds[face];
    }
    [[nodiscard]] Index faceBegin(std::size_t face) const { return face == 0 ? 0 : faceEnd(face - 1); }
    [[nodiscard]] std::span<const Index> face(std::size_t i) const
    {
        return {corners.data() + faceBegin(i), corners.data() + faceEnd(i)};
    }
    [[nodiscard]] long lineOf(std::size_t face) const
    {
        return faceLines.empty() ? 0 : static_cast<long>(faceLines[face]);
    }
};

} // namespace reflectance
