#include "core/geometry/topology.h"

#include "core/geometry/weld.h"

// OpenMesh's headers do not pass this project's warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#pragma GCC diagnostic pop

#include <algorithm>
#include <numeric>
#include <tuple>

namespace reflectance {
namespace {

using Index = std::uint32_t;
using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<>;

/// One side of a triangle: its two vertices in ascending order.
struct Side {
    Index low, high;
    Index triangle;
    bool ascends; ///< the triangle runs from low to high

    [[nodiscard]] bool sameEdge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Mesh::Triangle> weldedTriangles(const Mesh& mesh)
{
    const std::vector<Index> first = firstAtSamePlace(mesh.positions);
    std::vector<Mesh::Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const Mesh::Triangle& t : mesh.triangles)
        triangles.push_back({first[t[0]], first[t[1]], first[t[2]]});
    return triangles;
}

std::vector<Side> sortedSides(const std::vector<Mesh::Triangle>& triangles)
{
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (Index t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = triangles[t][k];
            const Index b = triangles[t][(k + 1) % 3];
            // Two corners at one place happen where placing rounds tiny edges to nothing: no edge.
            if (a != b)
                sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return sides;
}

class Pieces {
public:
    explicit Pieces(std::size_t count) : parent_(count), count_(count)
    {
        std::iota(parent_.begin(), parent_.end(), Index{0});
    }

    void join(Index a, Index b)
    {
        const Index rootA = root(a);
        const Index rootB = root(b);
        if (rootA == rootB)
            return;
        parent_[rootA] = rootB;
        --count_;
    }
    [[nodiscard]] std::size_t count() const { return count_; }

private:
    Index root(Index i)
    {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    std::vector<Index> parent_;
    std::size_t count_;
};

std::size_t distinctVertices(const std::vector<Mesh::Triangle>& triangles, std::size_t positions)
{
    std::vector<bool> used(positions, false);
    for (const Mesh::Triangle& t : triangles)
        for (const Index v : t)
            used[v] = true;
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

/// Everything that can be told by counting the sides of each edge.
void countEdges(const std::vector<Side>& sides, TopologySummary& summary)
{
    Pieces pieces(summary.triangles);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        for (end = begin; end < sides.size() && sides[end].sameEdge(sides[begin]); ++end)
            pieces.join(sides[begin].triangle, sides[end].triangle);
        ++summary.edges;
        summary.boundaryEdges += end - begin == 1 ? 1 : 0;
        summary.nonManifoldEdges += end - begin > 2 ? 1 : 0;
        summary.windingConflicts += end - begin == 2 && sides[begin].ascends == sides[begin + 1].ascends ? 1 : 0;
    }
    summary.components = pieces.count();
}

/// The half-edge structure; triangles that it refuses get vertices of their own, so that none is lost.
class HalfEdgeBuilder {
public:
    explicit HalfEdgeBuilder(std::size_t positions) : handles_(positions)
    {
        omerr().disable(); // it reports each refusal on stderr; here they are counted
    }

    void add(const Mesh::Triangle& t)
    {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            return;
        if (!mesh_.add_face(handle(t[0]), handle(t[1]), handle(t[2])).is_valid()) {
            mesh_.add_face(fresh(t[0]), fresh(t[1]), fresh(t[2]));
            ++separated_;
        }
    }

    [[nodiscard]] const HalfEdges& mesh() const { return mesh_; }
    [[nodiscard]] Index vertexOf(HalfEdges::VertexHandle handle) const
    {
        return origin_[static_cast<std::size_t>(handle.idx())];
    }
    [[nodiscard]] std::size_t separated() const { return separated_; }

private:
    HalfEdges::VertexHandle handle(Index vertex)
    {
        if (!handles_[vertex].is_valid())
            handles_[vertex] = fresh(vertex);
        return handles_[vertex];
    }
    HalfEdges::VertexHandle fresh(Index vertex)
    {
        origin_.push_back(vertex);
        return mesh_.add_vertex({});
    }

    HalfEdges mesh_;
    std::vector<HalfEdges::VertexHandle> handles_; ///< of each position
    std::vector<Index> origin_;                    ///< of each handle
    std::size_t separated_ = 0;
};

bool isBoundary(const std::vector<Side>& sides, Index a, Index b)
{
    const Side wanted{std::min(a, b), std::max(a, b), 0, false};
    const auto [first, last] = std::equal_range(sides.begin(), sides.end(), wanted, [](const Side& s, const Side& t) {
        return std::tie(s.low, s.high) < std::tie(t.low, t.high);
    });
    return last - first == 1;
}

/// Chains of half-edges without a triangle. Rims that exist only because a triangle was separated are no holes.
std::vector<std::vector<Index>> loopsOf(const HalfEdgeBuilder& builder, const std::vector<Side>& sides)
{
    std::vector<std::vector<Index>> loops;
    const HalfEdges& mesh = builder.mesh();
    std::vector<bool> isVisited(mesh.n_halfedges(), false);
    for (const auto start : mesh.halfedges()) {
        if (!start.is_boundary() || isVisited[static_cast<std::size_t>(start.idx())])
            continue;
        std::vector<Index> loop;
        bool isHole = false;
        for (auto side = start; !isVisited[static_cast<std::size_t>(side.idx())]; side = side.next()) {
            isVisited[static_cast<std::size_t>(side.idx())] = true;
            loop.push_back(builder.vertexOf(side.from()));
            isHole = isHole || isBoundary(sides, builder.vertexOf(side.from()), builder.vertexOf(side.to()));
        }
        if (isHole)
            loops.push_back(std::move(loop));
    }
    return loops;
}

} // namespace

struct Topology::Body {
    TopologySummary summary;
    std::vector<std::vector<std::uint32_t>> loops;
};

Topology::Topology(const Mesh& mesh) : body_(std::make_unique<Body>())
{
    const std::vector<Mesh::Triangle> triangles = weldedTriangles(mesh);
    const std::vector<Side> sides = sortedSides(triangles);
    HalfEdgeBuilder builder(mesh.positions.size());
    for (const Mesh::Triangle& triangle : triangles)
        builder.add(triangle);
    body_->loops = loopsOf(builder, sides);
    TopologySummary& summary = body_->summary;
    summary.triangles = triangles.size();
    summary.vertices = distinctVertices(triangles, mesh.positions.size());
    summary.boundaryLoops = body_->loops.size();
    summary.separatedTriangles = builder.separated();
    countEdges(sides, summary);
}

Topology::Topology(Topology&&) noexcept = default;
Topology& Topology::operator=(Topology&&) noexcept = default;
Topology::~Topology() = default;

const TopologySummary& Topology::summary() const
{
    return body_->summary;
}

const std::vector<std::vector<std::uint32_t>>& Topology::boundaryLoops() const
{
    return body_->loops;
}

} // namespace reflectance
