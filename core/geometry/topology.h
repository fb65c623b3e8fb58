// How the triangles of a mesh hang together: holes, pieces, edges where more than two triangles meet. Built when
// somebody asks, not to draw. OpenMesh's half-edge structure stands behind it and is seen by topology.cpp alone.
#pragma once

#include "core/geometry/mesh.h"

#include <cstddef>
#include <memory>

namespace reflectance {

struct TopologySummary {
    std::size_t vertices = 0; ///< distinct positions
    std::size_t edges = 0;
    std::size_t triangles = 0;
    std::size_t components = 0;         ///< pieces whose triangles are joined by edges
    std::size_t boundaryEdges = 0;      ///< with one triangle
    std::size_t boundaryLoops = 0;      ///< holes and rims
    std::size_t nonManifoldEdges = 0;   ///< with three triangles or more
    std::size_t windingConflicts = 0;   ///< edges whose two triangles are wound against each other
    std::size_t separatedTriangles = 0; ///< which the half-edge structure took only with vertices of their own

    [[nodiscard]] bool isClosed() const { return boundaryEdges == 0 && nonManifoldEdges == 0; }
    /// V - E + F: 2 for each closed piece without a handle, 0 for a torus.
    [[nodiscard]] long eulerCharacteristic() const
    {
        return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(triangles);
    }
};

class Topology {
public:
    /// Vertices at the same position count as one: seams of normals are not holes.
    explicit Topology(const Mesh& mesh);
    Topology(Topology&&) noexcept;
    Topology& operator=(Topology&&) noexcept;
    ~Topology();

    [[nodiscard]] const TopologySummary& summary() const;

    /// Each hole or rim as a closed chain of the mesh's vertices.
    [[nodiscard]] const std::vector<std::vector<std::uint32_t>>& boundaryLoops() const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

} // namespace reflectance
