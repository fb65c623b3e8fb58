#include "core/geometry/assemble.h"

#include "core/base/parallel.h"
#include "core/geometry/large_pages.h"

#include <algorithm>
#include <functional>

namespace reflectance {
namespace {

using Index = PolygonSoup::Index;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::size_t perRange = 65536;

/// As length(), without its care where none is needed.
double quickLength(const Vec3d& v)
{
    const double squared = dot(v, v);
    return squared > 1e-200 && squared < 1e200 ? std::sqrt(squared) : length(v);
}

/// Folds what value(first, last) gives for every range: the same whatever the number of threads.
template <class T, class Value, class Fold>
T folded(int threads, std::size_t count, const T& start, const Value& value, const Fold& fold)
{
    std::vector<T> values((count + perRange - 1) / perRange, start);
    inRanges(threads, count, perRange,
             [&](std::size_t range, std::size_t first, std::size_t last) { values[range] = value(first, last); });
    T result = start;
    for (const T& each : values)
        result = fold(result, each);
    return result;
}

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

/// Gives the list's corners their mesh vertices, in the order in which they are first met. Returns how many file vertices
/// have none.
std::size_t splitVertices(const PolygonSoup& soup, TriangleList& list, const CornerNormals& normals, Mesh& mesh)
{
    VertexSplitter splitter(soup, mesh);
    for (std::size_t t = 0; t < list.vertices.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index normal = normals.corners[t][k];
            list.vertices[t][k] =
                splitter.vertex(list.vertices[t][k], normal == PolygonSoup::none ? Vec3d() : normals.normals[normal]);
        }
    return splitter.unused();
}

/// The same where every file vertex has one normal; those of the mesh are still to come.
std::size_t numberVertices(const PolygonSoup& soup, TriangleList& list, Mesh& mesh)
{
    std::vector<Index> meshVertex(soup.positions.size(), PolygonSoup::none);
    reserveInLargePages(mesh.fileVertex, soup.positions.size());
    for (Mesh::Triangle& triangle : list.vertices)
        for (Index& v : triangle) {
            Index& known = meshVertex[v];
            if (known == PolygonSoup::none) {
                known = static_cast<Index>(mesh.fileVertex.size());
                mesh.fileVertex.push_back(v);
            }
            v = known;
        }
    return soup.positions.size() - mesh.fileVertex.size();
}

struct Bounds {
    Vec3d lowest = Vec3d(infinity);
    Vec3d highest = Vec3d(-infinity);

    [[nodiscard]] Bounds with(const Bounds& b) const
    {
        return {{std::min(lowest.x, b.lowest.x), std::min(lowest.y, b.lowest.y), std::min(lowest.z, b.lowest.z)},
                {std::max(highest.x, b.highest.x), std::max(highest.y, b.highest.y), std::max(highest.z, b.highest.z)}};
    }
};

Bounds boundsOf(const PolygonSoup& soup, const Mesh& mesh, int threads)
{
    const auto bounds = [&](std::size_t first, std::size_t last) {
        Bounds range;
        for (std::size_t i = first; i < last; ++i)
            range = range.with({soup.positions[mesh.fileVertex[i]], soup.positions[mesh.fileVertex[i]]});
        return range;
    };
    return folded(threads, mesh.fileVertex.size(), Bounds(), bounds,
                  [](const Bounds& a, const Bounds& b) { return a.with(b); });
}

/// Halves first: the sum of two coordinates of 1e300 stays finite.
Placement placementOf(const PolygonSoup& soup, const Mesh& mesh, const Bounds& bounds, int threads)
{
    const Vec3d centre = 0.5 * bounds.lowest + 0.5 * bounds.highest;
    const auto farthest = [&](std::size_t first, std::size_t last) {
        double scale = 0.0;
        for (std::size_t i = first; i < last; ++i)
            scale = std::max(scale, quickLength(soup.positions[mesh.fileVertex[i]] - centre));
        return scale;
    };
    return {centre,
            folded(threads, mesh.fileVertex.size(), 0.0, farthest, [](double a, double b) { return std::max(a, b); })};
}

double areaOf(const PolygonSoup& soup, const TriangleList& list, int threads)
{
    const auto area = [&](std::size_t first, std::size_t last) {
        double sum = 0.0;
        for (std::size_t i = first; i < last; ++i) {
            const Mesh::Triangle& t = list.vertices[i];
            const Vec3d& a = soup.positions[t[0]];
            sum += 0.5 * quickLength(cross(soup.positions[t[1]] - a, soup.positions[t[2]] - a));
        }
        return sum;
    };
    return folded(threads, list.vertices.size(), 0.0, area, std::plus<>());
}

void placeVertices(const PolygonSoup& soup, Mesh& mesh)
{
    reserveInLargePages(mesh.positions, mesh.fileVertex.size());
    for (const Index v : mesh.fileVertex)
        mesh.positions.push_back((soup.positions[v] - mesh.placement.centre) / mesh.placement.scale);
}

/// Where every file vertex has one.
void copyNormals(const CornerNormals& normals, Mesh& mesh)
{
    reserveInLargePages(mesh.normals, mesh.fileVertex.size());
    for (const Index v : mesh.fileVertex)
        mesh.normals.push_back(normals.normals[v]);
}

} // namespace

Mesh assembled(const PolygonSoup& soup, TriangleList list, const CornerNormals& normals, MeshReport& report,
               int threads)
{
    Mesh mesh;
    report.area = areaOf(soup, list, threads);
    giveBack(list.faceNormals);
    report.unusedVertices =
        normals.isOfVertex ? numberVertices(soup, list, mesh) : splitVertices(soup, list, normals, mesh);
    mesh.triangles = std::move(list.vertices);
    const Bounds bounds = boundsOf(soup, mesh, threads);
    report.lowest = bounds.lowest;
    report.highest = bounds.highest;
    mesh.placement = placementOf(soup, mesh, bounds, threads);
    inRanges(threads, normals.isOfVertex ? 2 : 1, 1, [&](std::size_t task, std::size_t, std::size_t) {
        if (task == 0)
            placeVertices(soup, mesh);
        else
            copyNormals(normals, mesh);
    });
    mesh.fileVertexCount = soup.positions.size();
    report.meshVertices = mesh.positions.size();
    return mesh;
}

} // namespace reflectance
