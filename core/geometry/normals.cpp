#include "core/geometry/normals.h"

#include "core/base/parallel.h"
#include "core/geometry/corner_angles.h"
#include "core/geometry/corners_around.h"
#include "core/geometry/large_pages.h"
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

void turnOver(TriangleList& list, Mesh::Triangle& normals, std::size_t triangle)
{
    std::swap(list.vertices[triangle][1], list.vertices[triangle][2]);
    std::swap(normals[1], normals[2]);
    list.faceNormals[triangle] = -list.faceNormals[triangle];
}

struct NormalCounts {
    std::size_t without = 0, bad = 0, good = 0, flipped = 0;
};

bool isUsable(const std::vector<Vec3d>& normals, Index index)
{
    return index < normals.size() && !(normals[index] == Vec3d());
}

/// The indices that name something of use; `none` instead of the others.
std::vector<Mesh::Triangle> usableOf(const std::vector<Vec3d>& normals, std::vector<Mesh::Triangle> corners)
{
    for (Mesh::Triangle& triangle : corners)
        for (Index& index : triangle)
            if (!isUsable(normals, index))
                index = PolygonSoup::none;
    return corners;
}

/// Of one triangle: indices that name nothing of use become `none`.
void checkTriangle(const std::vector<Vec3d>& normals, TriangleList& list, std::size_t t, Mesh::Triangle& corners,
                   NormalCounts& counts)
{
    // On coarse meshes one or two smooth normals may see a triangle from behind; if all do, its winding is wrong.
    int along = 0;
    int against = 0;
    for (Index& index : corners) {
        const bool isAbsent = index == PolygonSoup::none;
        const bool isGood = isUsable(normals, index);
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

/// What lies around the vertices that are smoothed one normal after the other.
struct Around {
    const CornersAround& corners;
    const std::vector<Index>& vertices; ///< ascending

    [[nodiscard]] std::span<const Index> of(std::size_t i) const { return corners.of(vertices[i]); }
};

/// Numbers the new normals of the vertices through, range after range, behind those that are there.
void joinRanges(const Around& around, std::vector<std::vector<Vec3d>>& fresh, CornerNormals& normals, int threads)
{
    std::vector<std::size_t> begins;
    std::size_t total = normals.normals.size();
    for (const std::vector<Vec3d>& range : fresh) {
        begins.push_back(total);
        total += range.size();
    }
    normals.normals.resize(total);
    inRanges(threads, around.vertices.size(), perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
        const auto begin = static_cast<Index>(begins[range]);
        std::copy(fresh[range].begin(), fresh[range].end(), normals.normals.begin() + begin);
        giveBack(fresh[range]);
        for (std::size_t i = first; i < last; ++i)
            for (const Index corner : around.of(i)) {
                Index& index = normals.corners[corner / 3][corner % 3];
                if ((index & VertexSmoother::isFresh) != 0)
                    index = begin + (index & ~VertexSmoother::isFresh);
            }
    });
}

/// Computes what is missing around these vertices, whatever there is of creases, seams and normals of the file.
void smoothOneByOne(const SmoothedMesh& mesh, const Around& around, CornerNormals& normals, int threads)
{
    std::vector<std::vector<Vec3d>> fresh((around.vertices.size() + perRange - 1) / perRange);
    inRanges(threads, around.vertices.size(), perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
        VertexSmoother smoother(mesh);
        for (std::size_t i = first; i < last; ++i)
            smoother.smooth(around.of(i), normals.corners, fresh[range]);
    });
    joinRanges(around, fresh, normals, threads);
}

/// Gives one normal to every vertex for which one will do, and returns the others.
std::vector<Index> smoothWhole(const SmoothedMesh& mesh, const CornersAround& around, std::vector<Vec3d>& normals,
                               int threads)
{
    resizeInLargePages(normals, around.vertices());
    std::vector<std::vector<Index>> left((around.vertices() + perRange - 1) / perRange);
    inRanges(threads, around.vertices(), perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
        const VertexSmoother smoother(mesh);
        for (std::size_t v = first; v < last; ++v)
            if (const auto normal = smoother.oneNormal(around.of(v)))
                normals[v] = *normal;
            else if (!around.of(v).empty())
                left[range].push_back(static_cast<Index>(v));
    });
    std::vector<Index> all;
    for (const std::vector<Index>& range : left)
        all.insert(all.end(), range.begin(), range.end());
    return all;
}

/// Every corner's index of its vertex's normal; `none` at these vertices.
void nameNormals(const SmoothedMesh& mesh, const Around& except, CornerNormals& normals, int threads)
{
    normals.corners.resize(mesh.list.vertices.size());
    inRanges(threads, normals.corners.size(), perRange, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t)
            for (std::size_t k = 0; k < 3; ++k)
                normals.corners[t][k] = mesh.vertexOf[mesh.list.vertices[t][k]];
    });
    for (std::size_t i = 0; i < except.vertices.size(); ++i)
        for (const Index corner : except.of(i))
            normals.corners[corner / 3][corner % 3] = PolygonSoup::none;
}

/// Vertices at the same place have the same normal.
void spreadNormals(const std::vector<Index>& vertexOf, std::vector<Vec3d>& normals, int threads)
{
    inRanges(threads, normals.size(), perRange, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v)
            if (vertexOf[v] != v) // the first of a place is its own, so that none is read that is being written
                normals[v] = normals[vertexOf[v]];
    });
}

std::size_t missingIn(const CornerNormals& normals, const TriangleList& list)
{
    if (normals.areAllMissing())
        return 3 * list.vertices.size();
    std::size_t count = 0;
    for (const Mesh::Triangle& corners : normals.corners)
        count += static_cast<std::size_t>(std::count(corners.begin(), corners.end(), PolygonSoup::none));
    return count;
}

} // namespace

CornerNormals fileNormals(PolygonSoup& soup, TriangleList& list, MeshReport& report, int threads)
{
    const std::size_t triangles = list.vertices.size();
    CornerNormals result;
    if (!list.namesNormals()) {
        report.cornersWithoutNormal = 3 * triangles;
        return result;
    }
    result.normals = std::move(soup.normals);
    result.corners = std::move(list.normals);
    inRanges(threads, result.normals.size(), perRange, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            result.normals[i] = normalized(result.normals[i]);
    });
    std::vector<NormalCounts> counts((triangles + perRange - 1) / perRange);
    inRanges(threads, triangles, perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t) {
            Mesh::Triangle named = list.normalOfVertex ? list.vertices[t] : result.corners[t];
            checkTriangle(result.normals, list, t, named, counts[range]);
            if (!list.normalOfVertex)
                result.corners[t] = named;
        }
    });
    for (const NormalCounts& range : counts) {
        report.cornersWithoutNormal += range.without;
        report.cornersWithBadNormal += range.bad;
        report.cornersWithFileNormal += range.good;
        report.flippedTriangles += range.flipped;
    }
    result.isOfVertex = list.normalOfVertex && report.cornersWithBadNormal == 0;
    if (list.normalOfVertex && !result.isOfVertex)
        result.corners = usableOf(result.normals, list.vertices);
    return result;
}

void smoothMissingNormals(const PolygonSoup& soup, const TriangleList& list, double creaseAngleDegrees,
                          CornerNormals& normals, MeshReport& report, int threads)
{
    report.cornersWithComputedNormal = missingIn(normals, list);
    if (report.cornersWithComputedNormal == 0)
        return;
    // Beyond, indices of new normals could not be told from the file's; the mesh would take 200 GB.
    if (std::max(normals.normals.size(), 3 * list.vertices.size()) >= VertexSmoother::isFresh)
        throw std::bad_alloc();
    const std::vector<Index> vertexOf = firstAtSamePlace(soup.positions, threads);
    const CornersAround around = cornersAround(list.vertices, vertexOf, threads);
    const UnfilledVector<std::array<double, 3>> angles = cornerAngles(soup.positions, list.vertices, threads);
    // The hair's breadth lets a bend of exactly the crease angle count as smooth whatever the rounding.
    const double creaseCosine = std::cos(creaseAngleDegrees * std::numbers::pi / 180.0) - 1e-12;
    const SmoothedMesh mesh{list, vertexOf, angles, creaseCosine};
    std::vector<Index> oneByOne;
    if (normals.areAllMissing()) {
        oneByOne = smoothWhole(mesh, around, normals.normals, threads);
        if (oneByOne.empty()) {
            spreadNormals(vertexOf, normals.normals, threads);
            normals.isOfVertex = true;
            return;
        }
        nameNormals(mesh, {around, oneByOne}, normals, threads);
    } else {
        oneByOne.resize(soup.positions.size());
        std::iota(oneByOne.begin(), oneByOne.end(), Index{0});
    }
    smoothOneByOne(mesh, {around, oneByOne}, normals, threads);
}

} // namespace reflectance
