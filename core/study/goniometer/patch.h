// One period of a micro-surface. N = (0,0,1); the pattern repeats along x and y without end, so it has no edge.
#pragma once

#include "core/geometry/mesh.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace reflectance {

/// Triangles over the rectangle 0 .. width by 0 .. depth, the larger of which is 1. Opposite sides meet at equal heights.
struct Patch {
    double width = 1.0, depth = 1.0;
    std::vector<Vec3d> positions;
    std::vector<Mesh::Triangle> triangles;
};

/// A grid of heights, rows by columns, column x fastest; the sample after the last is the first again. Heights in the unit
/// of width and depth. At least one row and one column.
[[nodiscard]] Patch heightField(std::size_t columns, std::size_t rows, std::span<const double> heights, double width,
                                double depth);

/// Width and depth twice as large, with the mirrored patch beside and above: what is no tile becomes one, without a step.
[[nodiscard]] Patch mirroredTile(const Patch& patch);

/// The patch and a strip of what surrounds it, at least `margin` wide on each side, as one mesh for rays.
[[nodiscard]] std::shared_ptr<const Mesh> withSurroundings(const Patch& patch, double margin);

/// Root mean square of the facets' slope (tangent) over the mean plane, along x and y together.
[[nodiscard]] double rmsSlope(const Patch& patch);

} // namespace reflectance
