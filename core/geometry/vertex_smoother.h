// Normals of the corners around one vertex: what smoothMissingNormals does at each.
#pragma once

#include "core/geometry/triangle_list.h"

#include <optional>
#include <span>

namespace reflectance {

/// What smoothing knows of the whole mesh. All must outlive the smoother.
struct SmoothedMesh {
    const TriangleList& list;
    const std::vector<PolygonSoup::Index>& vertexOf;     ///< gives vertices at the same place one number
    const UnfilledVector<std::array<double, 3>>& angles; ///< of every triangle's corners
    double creaseCosine; ///< faces whose normals' product is less have a crease between them
};

/// Smooths one vertex at a time; its buffers are kept between vertices.
class VertexSmoother {
public:
    using Index = PolygonSoup::Index;

    /// Marks indices into `fresh`.
    static constexpr Index isFresh = Index{1} << 31U;

    explicit VertexSmoother(const SmoothedMesh& mesh) : mesh_(mesh) {}

    /// The one normal of all corners of a vertex (`around`, as 3 * triangle + place), where that is soon seen, as of nearly
    /// all vertices: few corners that are one fan without a crease. It is what `smooth` would give, to the bit.
    [[nodiscard]] std::optional<Vec3d> oneNormal(std::span<const Index> around) const;

    /// Gives those of `around` that have no normal one: its place in `fresh`, marked, goes into `corners`.
    void smooth(std::span<const Index> around, std::vector<Mesh::Triangle>& corners, std::vector<Vec3d>& fresh);

private:
    /// A corner's two edges end at these vertices.
    struct Spokes {
        Index next, previous;
    };
    struct Spoke {
        Index farVertex; ///< at the other end of an edge
        Index corner;    ///< which of the vertex's corners the edge bounds
        friend auto operator<=>(const Spoke&, const Spoke&) = default; // NOLINT(modernize-use-nullptr): not a pointer
    };

    void gather(std::span<const Index> around);
    void joinFans(std::span<const Index> around);
    void joinMany(std::span<const Index> around);
    void addUp(std::span<const Index> around);
    Index normalOf(Index i, Index corner, std::vector<Vec3d>& fresh);

    [[nodiscard]] Spokes spokesOf(Index corner) const;
    [[nodiscard]] bool isSmooth(Index cornerA, Index cornerB) const
    {
        return dot(mesh_.list.faceNormals[cornerA / 3], mesh_.list.faceNormals[cornerB / 3]) >= mesh_.creaseCosine;
    }
    [[nodiscard]] Vec3d weighted(Index corner) const
    {
        return mesh_.angles[corner / 3][corner % 3] * mesh_.list.faceNormals[corner / 3];
    }

    Index root(Index i)
    {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    const SmoothedMesh& mesh_;
    std::vector<Spokes> spokes_;
    std::vector<Spoke> sorted_;
    std::vector<Index> parent_;
    std::vector<Vec3d> sums_;
    std::vector<Index> normals_; ///< of each fan's root
};

} // namespace reflectance
