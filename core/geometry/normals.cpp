#include "core/geometry/normals.h"

#include "core/base/parallel.h"
#include "core/geometry/vertex_smoother.h"
#include "core/geometry/weld.h"

#include <algorithm>
#include <new>
#include <numbers>
#include <numeric>
#include <span>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

constexpr std::size_t perRange = 16384;

/// A corner is addressed as 3 * triangle + place.
struct CornersAround {
    std::vector<Index> ends;    ///< of each vertex's run in `corners`
    std::vector<Index> corners; ///< grouped by vertex, ascending

    [[nodiscard]] std::span<const Index> of(std::size_t vertex) const
    {
        return std::span(corners).subspan(ends[vertex], ends[vertex + 1] - ends[vertex]);
    }
};

/// Counted into the next vertex's place but one, so that the places end up where the runs do when they have been filled.
CornersAround cornersAround(const std::vector<Mesh::Triangle>& triangles, const std::vector<Index>& vertexOf,
                            std::size_t vertices)
{
    CornersAround around;
    around.ends.assign(vertices + 2, 0);
    for (const Mesh::Triangle& triangle : triangles)
        for (const Index v : triangle)
            ++around.ends[vertexOf[v] + 2];
    std::partial_sum(around.ends.begin(), around.ends.end(), around.ends.begin());
    around.corners.resize(3 * triangles.size());
    for (Index t = 0; t < triangles.size(); ++t)
        for (Index k = 0; k < 3; ++k)
            around.corners[around.ends[vertexOf[triangles[t][k]] + 1]++] = 3 * t + k;
    around.ends.pop_back();
    return around;
}

void turnOver(TriangleList& list, Mesh::Triangle& normals, std::size_t triangle)
{
    std::swap(list.vertices[triangle][1], list.vertices[triangle][2]);
    std::swap(normals[1], normals[2]);
    list.faceNormals[triangle] = -list.faceNormals[triangle];
}

struct NormalCounts {
    std::size_t without = 0, bad = 0, good = 0, flipped = 0;
};

/// Of one triangle: indices that name nothing of use become `none`.
void checkTriangle(const std::vector<Vec3d>& normals, TriangleList& list, std::size_t t, Mesh::Triangle& corners,
                   NormalCounts& counts)
{
    // On coarse meshes one or two smooth normals may see a triangle from behind; if all do, its winding is wrong.
    int along = 0;
    int against = 0;
    for (Index& index : corners) {
        const bool isAbsent = index == PolygonSoup::none;
        const bool isGood = index < normals.size() && !(normals[index] == Vec3d());
        ++(isAbsent ? counts.without : (isGood ? counts.good : counts.bad));
        if (!isGood) {
            index = PolygonSoup::none;
            continue;
        }
        const double side = dot(normals[index], list.faceNormals[t]);
        along += side > 0.0 ? 1 : 0;
        against += side < 0.0 ? 1 : 0;
    }
    if (against > 0 && along == 0) {
        turnOver(list, corners, t);
        ++counts.flipped;
    }
}

/// Numbers the new normals of all vertices through, range after range, behind those of the file.
void joinRanges(const CornersAround& around, std::vector<std::vector<Vec3d>>& fresh, CornerNormals& normals,
                int threads)
{
    std::vector<std::size_t> begins;
    std::size_t total = normals.normals.size();
    for (const std::vector<Vec3d>& range : fresh) {
        begins.push_back(total);
        total += range.size();
    }
    normals.normals.resize(total);
    inRanges(threads, around.ends.size() - 1, perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
        const auto begin = static_cast<Index>(begins[range]);
        std::copy(fresh[range].begin(), fresh[range].end(), normals.normals.begin() + begin);
        giveBack(fresh[range]);
        for (Index at = around.ends[first]; at < around.ends[last]; ++at) {
            Index& index = normals.corners[around.corners[at] / 3][around.corners[at] % 3];
            if ((index & VertexSmoother::isFresh) != 0)
                index = begin + (index & ~VertexSmoother::isFresh);
        }
    });
}

} // namespace

CornerNormals fileNormals(PolygonSoup& soup, TriangleList& list, MeshReport& report, int threads)
{
    const std::size_t triangles = list.vertices.size();
    CornerNormals result;
    if (!list.namesNormals()) {
        result.corners.assign(triangles, {PolygonSoup::none, PolygonSoup::none, PolygonSoup::none});
        report.cornersWithoutNormal = 3 * triangles;
        return result;
    }
    result.normals = std::move(soup.normals);
    result.corners = list.normalOfVertex ? list.vertices : std::move(list.normals);
    giveBack(list.normals);
    inRanges(threads, result.normals.size(), perRange, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            result.normals[i] = normalized(result.normals[i]);
    });
    std::vector<NormalCounts> counts((triangles + perRange - 1) / perRange);
    inRanges(threads, triangles, perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t)
            checkTriangle(result.normals, list, t, result.corners[t], counts[range]);
    });
    for (const NormalCounts& range : counts) {
        report.cornersWithoutNormal += range.without;
        report.cornersWithBadNormal += range.bad;
        report.cornersWithFileNormal += range.good;
        report.flippedTriangles += range.flipped;
    }
    return result;
}

void smoothMissingNormals(const PolygonSoup& soup, const TriangleList& list, double creaseAngleDegrees,
                          CornerNormals& normals, MeshReport& report, int threads)
{
    for (const Mesh::Triangle& corners : normals.corners)
        report.cornersWithComputedNormal +=
            static_cast<std::size_t>(std::count(corners.begin(), corners.end(), PolygonSoup::none));
    if (report.cornersWithComputedNormal == 0)
        return;
    // Beyond, indices of new normals could not be told from the file's; the mesh would take 200 GB.
    if (std::max(normals.normals.size(), 3 * list.vertices.size()) >= VertexSmoother::isFresh)
        throw std::bad_alloc();
    const std::vector<Index> vertexOf = firstAtSamePlace(soup.positions);
    const std::size_t vertices = soup.positions.size();
    const CornersAround around = cornersAround(list.vertices, vertexOf, vertices);
    // The hair's breadth lets a bend of exactly the crease angle count as smooth whatever the rounding.
    const double creaseCosine = std::cos(creaseAngleDegrees * std::numbers::pi / 180.0) - 1e-12;
    std::vector<std::vector<Vec3d>> fresh((vertices + perRange - 1) / perRange);
    inRanges(threads, vertices, perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
        VertexSmoother smoother(soup.positions, list, vertexOf, creaseCosine);
        for (std::size_t v = first; v < last; ++v)
            smoother.smooth(around.of(v), normals.corners, fresh[range]);
    });
    joinRanges(around, fresh, normals, threads);
}

} // namespace reflectance
