// Triangles taken a block at a time, coordinate by coordinate, for loops that do one thing to all of them.
#pragma once

#include "core/base/parallel.h"
#include "core/geometry/mesh.h"
#include "core/geometry/triangle_sides.h"

#include <array>
#include <limits>
#include <span>

namespace reflectance {

struct TriangleBlock {
    static constexpr std::size_t capacity = 64;
    using Numbers = std::array<double, capacity>;

    std::size_t first = 0; ///< which of all triangles begins it
    std::size_t count = 0;
    std::array<std::array<Numbers, 3>, 3> coordinates{}; ///< of each corner, along each axis; behind `count` older ones

    /// With `first` and `count` given. A corner that names no position gets NaN.
    template <class VertexAt> void fill(std::span<const Vec3d> positions, const VertexAt& vertexAt)
    {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = vertexAt(first + i, k);
                const Vec3d p = v < positions.size() ? positions[v] : Vec3d(nan);
                coordinates[k][0][i] = p.x;
                coordinates[k][1][i] = p.y;
                coordinates[k][2][i] = p.z;
            }
    }

    [[nodiscard]] Vec3d corner(std::size_t k, std::size_t i) const
    {
        return {coordinates[k][0][i], coordinates[k][1][i], coordinates[k][2][i]};
    }
    [[nodiscard]] TriangleSides<double> sides(std::size_t i) const
    {
        return {corner(0, i), corner(1, i), corner(2, i)};
    }
};

/// Calls body(block) for all of `triangles` triangles, from several threads; vertexAt(triangle, corner) is into `positions`.
template <class VertexAt, class Body>
void inBlocks(int threads, std::span<const Vec3d> positions, std::size_t triangles, const VertexAt& vertexAt,
              const Body& body)
{
    constexpr std::size_t perRange = 256 * TriangleBlock::capacity;
    inRanges(threads, triangles, perRange, [&](std::size_t, std::size_t first, std::size_t last) {
        TriangleBlock block;
        for (block.first = first; block.first < last; block.first += TriangleBlock::capacity) {
            block.count = std::min(TriangleBlock::capacity, last - block.first);
            block.fill(positions, vertexAt);
            body(block);
        }
    });
}

} // namespace reflectance
