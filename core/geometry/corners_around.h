// The corners that meet at each vertex.
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/unfilled.h"

#include <span>

namespace reflectance {

/// A corner is addressed as 3 * triangle + place.
struct CornersAround {
    std::vector<std::uint32_t> ends;       ///< of each vertex's run in `corners`
    UnfilledVector<std::uint32_t> corners; ///< grouped by vertex, ascending

    [[nodiscard]] std::size_t vertices() const { return ends.size() - 1; }
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t vertex) const
    {
        return std::span(corners).subspan(ends[vertex], ends[vertex + 1] - ends[vertex]);
    }
};

/// `vertexOf` gives vertices that count as one the same number, below its size.
[[nodiscard]] CornersAround cornersAround(std::span<const Mesh::Triangle> triangles,
                                          std::span<const std::uint32_t> vertexOf, int threads = 1);

} // namespace reflectance
