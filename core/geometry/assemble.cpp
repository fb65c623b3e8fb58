#include "core/geometry/assemble.h"

#include <algorithm>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Hands out one mesh vertex for each pair of file vertex and normal.
class VertexSplitter {
public:
    VertexSplitter(const PolygonSoup& soup, Mesh& mesh) : mesh_(mesh), newest_(soup.positions.size(), PolygonSoup::none)
    {
        mesh.normals.reserve(soup.positions.size());
        mesh.fileVertex.reserve(soup.positions.size());
        older_.reserve(soup.positions.size());
    }

    Index vertex(Index fileVertex, const Vec3d& normal)
    {
        // A vertex rarely has more than a few normals; past some the search costs more than one vertex too many.
        constexpr int longestSearch = 64;
        Index known = newest_[fileVertex];
        for (int i = 0; known != PolygonSoup::none && i < longestSearch; ++i, known = older_[known])
            if (mesh_.normals[known] == normal)
                return known;
        const Index fresh = static_cast<Index>(mesh_.normals.size());
        mesh_.normals.push_back(normal);
        mesh_.fileVertex.push_back(fileVertex);
        older_.push_back(newest_[fileVertex]);
        newest_[fileVertex] = fresh;
        return fresh;
    }

    std::size_t unused() const
    {
        return static_cast<std::size_t>(std::count(newest_.begin(), newest_.end(), PolygonSoup::none));
    }

private:
    Mesh& mesh_;
    std::vector<Index> newest_; ///< of each file vertex, the mesh vertex made last
    std::vector<Index> older_;  ///< of each mesh vertex, the one made before it for the same file vertex
};

void measureBounds(const PolygonSoup& soup, const Mesh& mesh, MeshReport& report)
{
    report.lowest = Vec3d(infinity);
    report.highest = Vec3d(-infinity);
    for (const Index v : mesh.fileVertex) {
        const Vec3d& p = soup.positions[v];
        report.lowest = {std::min(report.lowest.x, p.x), std::min(report.lowest.y, p.y),
                         std::min(report.lowest.z, p.z)};
        report.highest = {std::max(report.highest.x, p.x), std::max(report.highest.y, p.y),
                          std::max(report.highest.z, p.z)};
    }
}

/// Halves first: the sum of two coordinates of 1e300 stays finite.
Placement placementOf(const PolygonSoup& soup, const Mesh& mesh, const MeshReport& report)
{
    Placement placement{0.5 * report.lowest + 0.5 * report.highest, 0.0};
    for (const Index v : mesh.fileVertex)
        placement.scale = std::max(placement.scale, length(soup.positions[v] - placement.centre));
    return placement;
}

double areaOf(const PolygonSoup& soup, const TriangleList& list)
{
    double area = 0.0;
    for (const Mesh::Triangle& t : list.vertices)
        area += 0.5 *
                length(cross(soup.positions[t[1]] - soup.positions[t[0]], soup.positions[t[2]] - soup.positions[t[0]]));
    return area;
}

} // namespace

Mesh assembled(const PolygonSoup& soup, TriangleList list, const CornerNormals& normals, MeshReport& report)
{
    Mesh mesh;
    report.area = areaOf(soup, list);
    giveBack(list.faceNormals);
    VertexSplitter splitter(soup, mesh);
    for (std::size_t t = 0; t < list.vertices.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            list.vertices[t][k] = splitter.vertex(list.vertices[t][k], normals.at(t, k));
    mesh.triangles = std::move(list.vertices);
    measureBounds(soup, mesh, report);
    mesh.placement = placementOf(soup, mesh, report);
    mesh.positions.reserve(mesh.fileVertex.size());
    for (const Index v : mesh.fileVertex)
        mesh.positions.push_back((soup.positions[v] - mesh.placement.centre) / mesh.placement.scale);
    mesh.fileVertexCount = soup.positions.size();
    report.meshVertices = mesh.positions.size();
    report.unusedVertices = splitter.unused();
    return mesh;
}

} // namespace reflectance
