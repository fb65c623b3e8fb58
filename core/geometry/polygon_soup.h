// What every mesh reader delivers: polygons as the file lists them, in double, nothing repaired yet.
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace reflectance {

struct PolygonSoup {
    using Index = std::uint32_t;

    /// An index that names nothing: absent in the file, or impossible.
    static constexpr Index none = std::numeric_limits<Index>::max();

    std::string format;               ///< "OBJ"
    std::vector<Vec3d> positions;     ///< may hold NaN: a damaged vertex keeps its place, so that no index shifts
    std::vector<Vec3d> normals;       ///< as listed, not necessarily unit
    std::vector<Index> corners;       ///< positions of all faces' corners, face after face; may be out of range
    std::vector<Index> cornerNormals; ///< into normals, one per corner; empty where no face names a normal
    std::vector<Index> faceEnds;      ///< corners of face i end before faceEnds[i]
    std::vector<Index> faceLines;     ///< line of each face; empty for binary files
    std::vector<std::string> notes;   ///< "materials are ignored"

    [[nodiscard]] std::size_t faceCount() const { return faceEnds.size(); }
    [[nodiscard]] Index faceBegin(std::size_t face) const { return face == 0 ? 0 : faceEnds[face - 1]; }
    [[nodiscard]] std::span<const Index> face(std::size_t i) const
    {
        return {corners.data() + faceBegin(i), corners.data() + faceEnds[i]};
    }
    [[nodiscard]] long lineOf(std::size_t face) const
    {
        return faceLines.empty() ? 0 : static_cast<long>(faceLines[face]);
    }
};

} // namespace reflectance
