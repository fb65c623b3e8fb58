#include "core/geometry/normals.h"

#include "core/geometry/weld.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

/// A corner is addressed as 3 * triangle + place.
struct CornersAround {
    std::vector<Index> ends;    ///< of each vertex's run in `corners`
    std::vector<Index> corners; ///< grouped by vertex, ascending
};

CornersAround cornersAround(const std::vector<Mesh::Triangle>& triangles, const std::vector<Index>& vertexOf,
                            std::size_t vertices)
{
    CornersAround around;
    around.ends.assign(vertices + 1, 0);
    for (const Mesh::Triangle& triangle : triangles)
        for (const Index v : triangle)
            ++around.ends[vertexOf[v] + 1];
    std::partial_sum(around.ends.begin(), around.ends.end(), around.ends.begin());
    std::vector<Index> next(around.ends.begin(), around.ends.end() - 1);
    around.corners.resize(3 * triangles.size());
    for (Index t = 0; t < triangles.size(); ++t)
        for (Index k = 0; k < 3; ++k)
            around.corners[next[vertexOf[triangles[t][k]]]++] = 3 * t + k;
    return around;
}

/// Angle at a between the directions to b and c. atan2 keeps its precision where acos loses half (hazard H16).
double angleAt(const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
    const Vec3d u = normalized(b - a);
    const Vec3d w = normalized(c - a);
    return std::atan2(length(cross(u, w)), dot(u, w));
}

/// Smooths around one vertex at a time; its buffers are kept between vertices.
class VertexSmoother {
public:
    VertexSmoother(const PolygonSoup& soup, const TriangleList& list, const std::vector<Index>& vertexOf,
                   double creaseCosine)
        : soup_(soup), list_(list), vertexOf_(vertexOf), creaseCosine_(creaseCosine)
    {
    }

    /// Sets the normals of those of `corners` (all corners at one vertex) that are still (0,0,0).
    void smooth(std::span<const Index> corners, CornerNormals& normals)
    {
        if (std::none_of(corners.begin(), corners.end(), [&](Index c) { return normals[c / 3][c % 3] == Vec3d(); }))
            return;
        joinFans(corners);
        sums_.assign(corners.size(), Vec3d());
        for (Index i = 0; i < corners.size(); ++i) {
            const auto [a, b, c] = pointsFrom(corners[i]);
            sums_[root(i)] += angleAt(a, b, c) * list_.faceNormals[corners[i] / 3];
        }
        for (Index i = 0; i < corners.size(); ++i) {
            Vec3d& normal = normals[corners[i] / 3][corners[i] % 3];
            const Vec3d& sum = sums_[root(i)];
            // The weights of a fan add up to a few radians; a sum of 1e-9 is what rounding left of a cancellation.
            if (normal == Vec3d())
                normal = length(sum) > 1e-9 ? normalized(sum) : list_.faceNormals[corners[i] / 3];
        }
    }

private:
    struct Spoke {
        Index farVertex; ///< at the other end of an edge
        Index corner;    ///< which of the vertex's corners the edge bounds
        friend auto operator<=>(const Spoke&, const Spoke&) = default; // NOLINT(modernize-use-nullptr): not a pointer
    };

    /// Joins corners that share a spoke, unless the surface folds there by more than the crease angle.
    void joinFans(std::span<const Index> corners)
    {
        parent_.resize(corners.size());
        std::iota(parent_.begin(), parent_.end(), Index{0});
        spokes_.clear();
        for (Index i = 0; i < corners.size(); ++i)
            for (const Index step : {1U, 2U})
                spokes_.push_back({vertexOf_[list_.vertices[corners[i] / 3][(corners[i] + step) % 3]], i});
        std::sort(spokes_.begin(), spokes_.end());
        for (std::size_t i = 1; i < spokes_.size(); ++i)
            // An edge usually has two faces; on one with hundreds each is compared with the nearest few only.
            for (std::size_t j = i; j-- > 0 && i - j <= 16 && spokes_[j].farVertex == spokes_[i].farVertex;)
                if (isSmooth(corners[spokes_[i].corner], corners[spokes_[j].corner]))
                    parent_[root(spokes_[i].corner)] = root(spokes_[j].corner);
    }

    bool isSmooth(Index cornerA, Index cornerB) const
    {
        return dot(list_.faceNormals[cornerA / 3], list_.faceNormals[cornerB / 3]) >= creaseCosine_;
    }

    Index root(Index i)
    {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    std::array<Vec3d, 3> pointsFrom(Index corner) const
    {
        const Mesh::Triangle& v = list_.vertices[corner / 3];
        const Index k = corner % 3;
        return {soup_.positions[v[k]], soup_.positions[v[(k + 1) % 3]], soup_.positions[v[(k + 2) % 3]]};
    }

    const PolygonSoup& soup_;
    const TriangleList& list_;
    const std::vector<Index>& vertexOf_;
    double creaseCosine_;
    std::vector<Spoke> spokes_;
    std::vector<Index> parent_;
    std::vector<Vec3d> sums_;
};

void turnOver(TriangleList& list, std::size_t triangle)
{
    std::swap(list.vertices[triangle][1], list.vertices[triangle][2]);
    std::swap(list.normals[triangle][1], list.normals[triangle][2]);
    list.faceNormals[triangle] = -list.faceNormals[triangle];
}

} // namespace

CornerNormals fileNormals(const PolygonSoup& soup, TriangleList& list, MeshReport& report)
{
    CornerNormals normals(list.vertices.size());
    if (list.normals.empty()) {
        report.cornersWithoutNormal = 3 * list.vertices.size();
        return normals;
    }
    for (std::size_t t = 0; t < list.vertices.size(); ++t) {
        // On coarse meshes one or two smooth normals may see a triangle from behind; if all do, its winding is wrong.
        int along = 0;
        int against = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Index index = list.normals[t][k];
            normals[t][k] = index < soup.normals.size() ? normalized(soup.normals[index]) : Vec3d();
            const bool isBad = normals[t][k] == Vec3d();
            ++(index == PolygonSoup::none ? report.cornersWithoutNormal
                                          : (isBad ? report.cornersWithBadNormal : report.cornersWithFileNormal));
            const double side = dot(normals[t][k], list.faceNormals[t]);
            along += side > 0.0 ? 1 : 0;
            against += side < 0.0 ? 1 : 0;
        }
        if (against > 0 && along == 0) {
            turnOver(list, t);
            std::swap(normals[t][1], normals[t][2]);
            ++report.flippedTriangles;
        }
    }
    return normals;
}

void smoothMissingNormals(const PolygonSoup& soup, const TriangleList& list, double creaseAngleDegrees,
                          CornerNormals& normals, MeshReport& report)
{
    const auto isMissing = [](const Vec3d& normal) { return normal == Vec3d(); };
    for (const auto& corners : normals)
        report.cornersWithComputedNormal +=
            static_cast<std::size_t>(std::count_if(corners.begin(), corners.end(), isMissing));
    if (report.cornersWithComputedNormal == 0)
        return;
    const std::vector<Index> vertexOf = firstAtSamePlace(soup.positions);
    const CornersAround around = cornersAround(list.vertices, vertexOf, soup.positions.size());
    // The hair's breadth lets a bend of exactly the crease angle count as smooth whatever the rounding.
    const double creaseCosine = std::cos(creaseAngleDegrees * std::numbers::pi / 180.0) - 1e-12;
    VertexSmoother smoother(soup, list, vertexOf, creaseCosine);
    for (std::size_t v = 0; v + 1 < around.ends.size(); ++v)
        smoother.smooth(std::span(around.corners).subspan(around.ends[v], around.ends[v + 1] - around.ends[v]),
                        normals);
}

} // namespace reflectance
