#include "core/geometry/corners_around.h"

#include "core/base/parallel.h"

#include <utility>

namespace reflectance {
namespace {

using Index = std::uint32_t;

/// The triangles are counted in slices, one thread each; every slice keeps a number per vertex, so they are few.
std::size_t slicesFor(std::size_t triangles, int threads)
{
    constexpr std::size_t fewest = 65536; // what is worth a thread
    constexpr std::size_t most = 4;
    return std::clamp<std::size_t>(std::min<std::size_t>(static_cast<std::size_t>(threads), triangles / fewest), 1,
                                   most);
}

} // namespace

CornersAround cornersAround(std::span<const Mesh::Triangle> triangles, std::span<const Index> vertexOf, int threads)
{
    const std::size_t vertices = vertexOf.size();
    const std::size_t slices = slicesFor(triangles.size(), threads);
    const std::size_t perSlice = (triangles.size() + slices - 1) / slices;
    std::vector<std::vector<Index>> places(slices); // first how many, then where the next one goes
    inRanges(threads, triangles.size(), perSlice, [&](std::size_t slice, std::size_t first, std::size_t last) {
        places[slice].assign(vertices, 0);
        for (std::size_t t = first; t < last; ++t)
            for (const Index v : triangles[t])
                ++places[slice][vertexOf[v]];
    });
    CornersAround around;
    around.ends.resize(vertices + 1);
    Index end = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        around.ends[v] = end;
        for (std::vector<Index>& slice : places)
            end += std::exchange(slice[v], end);
    }
    around.ends[vertices] = end;
    around.corners.resize(3 * triangles.size());
    inRanges(threads, triangles.size(), perSlice, [&](std::size_t slice, std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t)
            for (std::size_t k = 0; k < 3; ++k)
                around.corners[places[slice][vertexOf[triangles[t][k]]]++] = static_cast<Index>(3 * t + k);
    });
    return around;
}

} // namespace reflectance
