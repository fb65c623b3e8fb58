#include "core/geometry/vertex_smoother.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace reflectance {
namespace {

/// Corners around a vertex up to which comparing every one with every other is quickest.
constexpr std::size_t few = 16;

/// The weights of a fan add up to a few radians; a sum of 1e-9 is what rounding left of a cancellation.
bool hasDirection(const Vec3d& sum)
{
    return dot(sum, sum) > 1e-18;
}

} // namespace

VertexSmoother::Spokes VertexSmoother::spokesOf(Index corner) const
{
    const Mesh::Triangle& v = mesh_.list.vertices[corner / 3];
    const Index place = corner % 3;
    return {mesh_.vertexOf[v[place == 2 ? 0 : place + 1]], mesh_.vertexOf[v[place == 0 ? 2 : place - 1]]};
}

std::optional<Vec3d> VertexSmoother::oneNormal(std::span<const Index> around) const
{
    if (around.empty() || around.size() > few)
        return std::nullopt;
    std::array<Spokes, few> spokes;
    Vec3d sum;
    for (std::size_t i = 0; i < around.size(); ++i) {
        spokes[i] = spokesOf(around[i]);
        sum += weighted(around[i]);
    }
    // From the first corner on over edges that are no crease, one way around and then the other, until all were met.
    unsigned left = (1U << around.size()) - 2U;
    const auto walk = [&](Index Spokes::*ahead, Index Spokes::*behind) {
        std::size_t at = 0;
        for (std::size_t i = 1; left != 0 && i < around.size(); ++i) {
            const bool isNext = (left >> i & 1U) != 0 && spokes[i].*behind == spokes[at].*ahead;
            if (!isNext || !isSmooth(around[at], around[i]))
                continue;
            left &= ~(1U << i);
            at = i;
            i = 0;
        }
    };
    walk(&Spokes::next, &Spokes::previous);
    walk(&Spokes::previous, &Spokes::next);
    return left == 0 && hasDirection(sum) ? std::optional(normalized(sum)) : std::nullopt;
}

void VertexSmoother::smooth(std::span<const Index> around, std::vector<Mesh::Triangle>& corners,
                            std::vector<Vec3d>& fresh)
{
    const auto normalAt = [&](Index corner) -> Index& { return corners[corner / 3][corner % 3]; };
    if (std::none_of(around.begin(), around.end(), [&](Index c) { return normalAt(c) == PolygonSoup::none; }))
        return;
    gather(around);
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
    for (const Index corner : around)
        spokes_.push_back(spokesOf(corner));
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
    for (Index i = 0; i < around.size(); ++i)
        sums_[root(i)] += weighted(around[i]);
}

VertexSmoother::Index VertexSmoother::normalOf(Index i, Index corner, std::vector<Vec3d>& fresh)
{
    Index& known = normals_[root(i)];
    if (known != PolygonSoup::none)
        return known;
    const auto added = isFresh | static_cast<Index>(fresh.size());
    const Vec3d& sum = sums_[root(i)];
    if (hasDirection(sum)) {
        fresh.push_back(normalized(sum));
        known = added;
    } else {
        fresh.push_back(mesh_.list.faceNormals[corner / 3]);
    }
    return added;
}

} // namespace reflectance
