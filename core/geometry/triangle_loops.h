// What is computed of a block of triangles at once, in the widest lanes of this processor. To the same bit as one by one, and
// on every processor: products and sums are never fused.
#pragma once

#include "core/geometry/triangle_block.h"

namespace reflectance {

/// Radians at each corner; nonsense in triangles that are not of handy size.
struct AngleBlock {
    std::array<TriangleBlock::Numbers, 3> angles;
    TriangleBlock::Numbers sizes; ///< TriangleSides::size
};

/// Unit normals by the winding; nonsense in triangles that are not of handy size, finite and with an area.
struct NormalBlock {
    std::array<TriangleBlock::Numbers, 3> normals;
    TriangleBlock::Numbers sizes, extents;
    TriangleBlock::Numbers excess; ///< by how much twice the area is more than rounding
};

struct TriangleLoops {
    void (*angles)(const TriangleBlock& block, AngleBlock& found);
    void (*normals)(const TriangleBlock& block, NormalBlock& found);
};

[[nodiscard]] const TriangleLoops& triangleLoopsSse2();
[[nodiscard]] const TriangleLoops& triangleLoopsAvx2(); ///< call only where the processor has AVX2
/// The widest that this processor runs.
[[nodiscard]] const TriangleLoops& triangleLoops();

} // namespace reflectance
