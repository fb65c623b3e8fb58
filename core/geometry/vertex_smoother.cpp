#include "core/geometry/vertex_smoother.h"

#include <algorithm>
#include <numeric>

namespace reflectance {
namespace {

/// Angle at a between the directions to b and c. atan2 keeps its precision where acos loses half (hazard H16).
double angleAt(const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
    Vec3d u = b - a;
    Vec3d w = c - a;
    const auto isHandy = [](double squared) { return squared > 1e-70 && squared < 1e70; };
    if (!isHandy(dot(u, u)) || !isHandy(dot(w, w))) { // products of four lengths would overflow or vanish
        u = normalized(u);
        w = normalized(w);
    }
    const Vec3d n = cross(u, w);
    return std::atan2(std::sqrt(dot(n, n)), dot(u, w));
}

} // namespace

void VertexSmoother::smooth(std::span<const Index> around, std::vector<Mesh::Triangle>& corners,
                            std::vector<Vec3d>& fresh)
{
    const auto normalAt = [&](Index corner) -> Index& { return corners[corner / 3][corner % 3]; };
    if (std::none_of(around.begin(), around.end(), [&](Index c) { return normalAt(c) == PolygonSoup::none; }))
        return;
    gather(around);
    constexpr std::size_t few = 16;
    if (around.size() <= few)
        joinFans(around);
    else
        joinMany(around);
    addUp(around);
    normals_.assign(around.size(), PolygonSoup::none);
    for (Index i = 0; i < around.size(); ++i)
        if (normalAt(around[i]) == PolygonSoup::none)
            normalAt(around[i]) = normalOf(i, around[i], fresh);
}

void VertexSmoother::gather(std::span<const Index> around)
{
    parent_.resize(around.size());
    std::iota(parent_.begin(), parent_.end(), Index{0});
    spokes_.clear();
    for (const Index corner : around) {
        const Mesh::Triangle& v = list_.vertices[corner / 3];
        spokes_.push_back({vertexOf_[v[(corner + 1) % 3]], vertexOf_[v[(corner + 2) % 3]]});
    }
}

/// Joins corners that share a spoke, unless the surface folds there by more than the crease angle: every corner with
/// every other, which is quickest for few.
void VertexSmoother::joinFans(std::span<const Index> around)
{
    for (Index i = 1; i < around.size(); ++i)
        for (Index j = 0; j < i; ++j) {
            const bool areNeighbours = spokes_[i].next == spokes_[j].previous ||
                                       spokes_[i].previous == spokes_[j].next || spokes_[i].next == spokes_[j].next ||
                                       spokes_[i].previous == spokes_[j].previous;
            if (areNeighbours && isSmooth(around[i], around[j]))
                parent_[root(i)] = root(j);
        }
}

/// The same for many corners.
void VertexSmoother::joinMany(std::span<const Index> around)
{
    sorted_.clear();
    for (Index i = 0; i < around.size(); ++i) {
        sorted_.push_back({spokes_[i].next, i});
        sorted_.push_back({spokes_[i].previous, i});
    }
    std::sort(sorted_.begin(), sorted_.end());
    for (std::size_t i = 1; i < sorted_.size(); ++i)
        // An edge usually has two faces; on one with hundreds each is compared with the nearest few only.
        for (std::size_t j = i; j-- > 0 && i - j <= 16 && sorted_[j].farVertex == sorted_[i].farVertex;)
            if (isSmooth(around[sorted_[i].corner], around[sorted_[j].corner]))
                parent_[root(sorted_[i].corner)] = root(sorted_[j].corner);
}

/// The face normals of every fan, weighted by the angle.
void VertexSmoother::addUp(std::span<const Index> around)
{
    sums_.assign(around.size(), Vec3d());
    for (Index i = 0; i < around.size(); ++i) {
        const Mesh::Triangle& v = list_.vertices[around[i] / 3];
        const Index k = around[i] % 3;
        const double angle = angleAt(positions_[v[k]], positions_[v[(k + 1) % 3]], positions_[v[(k + 2) % 3]]);
        sums_[root(i)] += angle * list_.faceNormals[around[i] / 3];
    }
}

VertexSmoother::Index VertexSmoother::normalOf(Index i, Index corner, std::vector<Vec3d>& fresh)
{
    Index& known = normals_[root(i)];
    if (known != PolygonSoup::none)
        return known;
    const auto added = isFresh | static_cast<Index>(fresh.size());
    // The weights of a fan add up to a few radians; a sum of 1e-9 is what rounding left of a cancellation.
    const Vec3d& sum = sums_[root(i)];
    if (dot(sum, sum) > 1e-18) {
        fresh.push_back(normalized(sum));
        known = added;
    } else {
        fresh.push_back(list_.faceNormals[corner / 3]);
    }
    return added;
}

} // namespace reflectance
