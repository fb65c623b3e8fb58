// A triangle mesh as a value, ready to draw: every vertex has one position and one normal.
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace reflectance {

/// How the file's coordinates became the mesh's: file = centre + scale * mesh. Computed in double before any float, so
/// that meshes 1e7 away from the origin, or 1e-20 small, look like any other.
struct Placement {
    Vec3d centre{};     ///< of the bounding box, in the file's units
    double scale = 1.0; ///< radius of the bounding sphere about the centre, in the file's units
};

struct Mesh {
    using Triangle = std::array<std::uint32_t, 3>;

    std::string name;             ///< "mug", for titles
    std::vector<Vec3d> positions; ///< centred, inside the unit sphere
    std::vector<Vec3d> normals;   ///< unit; as many as positions; they agree with the triangles' winding
    std::vector<std::uint32_t>
        fileVertex; ///< which of the file's vertices each came from: equal where a crease splits one
    std::size_t fileVertexCount = 0;
    std::vector<Triangle> triangles; ///< indices into positions, counter-clockwise seen from outside
    Placement placement;
};

} // namespace reflectance
