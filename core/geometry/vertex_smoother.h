// Normals of the corners around one vertex: what smoothMissingNormals does at each.
#pragma once

#include "core/geometry/triangle_list.h"

#include <span>

namespace reflectance {

/// Smooths one vertex at a time; its buffers are kept between vertices.
class VertexSmoother {
public:
    using Index = PolygonSoup::Index;

    /// Marks indices into `fresh`.
    static constexpr Index isFresh = Index{1} << 31U;

    /// All must outlive the smoother. `vertexOf` gives vertices at the same place one number.
    VertexSmoother(const std::vector<Vec3d>& positions, const TriangleList& list, const std::vector<Index>& vertexOf,
                   double creaseCosine)
        : positions_(positions), list_(list), vertexOf_(vertexOf), creaseCosine_(creaseCosine)
    {
    }

    /// Gives those of `around` (all corners at one vertex, as 3 * triangle + place) that have no normal one: its place
    /// in `fresh`, marked, goes into `corners`.
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

    [[nodiscard]] bool isSmooth(Index cornerA, Index cornerB) const
    {
        return dot(list_.faceNormals[cornerA / 3], list_.faceNormals[cornerB / 3]) >= creaseCosine_;
    }

    Index root(Index i)
    {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    const std::vector<Vec3d>& positions_;
    const TriangleList& list_;
    const std::vector<Index>& vertexOf_;
    double creaseCosine_;
    std::vector<Spokes> spokes_;
    std::vector<Spoke> sorted_;
    std::vector<Index> parent_;
    std::vector<Vec3d> sums_;
    std::vector<Index> normals_; ///< of each fan's root
};

} // namespace reflectance
