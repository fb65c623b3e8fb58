#include "core/geometry/clustered.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace reflectance {
namespace {

/// The face of a cube about the origin through which a direction leaves it.
std::uint64_t faceOf(const Vec3d& N)
{
    const double x = std::fabs(N.x), y = std::fabs(N.y), z = std::fabs(N.z);
    const auto pair = [](unsigned first, double c) { return static_cast<std::uint64_t>(first + (c < 0.0 ? 1U : 0U)); };
    return x >= y && x >= z ? pair(0, N.x) : y >= z ? pair(2, N.y) : pair(4, N.z);
}

/// The cell of a grid of `cells` across the unit sphere, and where the normal points.
std::uint64_t keyOf(const Vec3d& P, const Vec3d& N, int cells)
{
    const auto along = [cells](double c) {
        const double share = std::clamp(0.5 * (c + 1.0), 0.0, 1.0);
        return static_cast<std::uint64_t>(std::min(cells - 1.0, std::floor(share * cells)));
    };
    constexpr unsigned bits = 20;
    const std::uint64_t cell = (along(P.x) << (2U * bits)) | (along(P.y) << bits) | along(P.z);
    return (cell << 3U) | faceOf(N);
}

/// For each vertex the number of its cluster, and how many there are.
struct Clusters {
    std::vector<std::uint32_t> of;
    std::uint32_t count = 0;
};

Clusters clustersOf(const Mesh& mesh, int cells)
{
    Clusters clusters;
    clusters.of.reserve(mesh.positions.size());
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const auto [at, fresh] = numbers.try_emplace(keyOf(mesh.positions[i], mesh.normals[i], cells), clusters.count);
        clusters.count += fresh ? 1 : 0;
        clusters.of.push_back(at->second);
    }
    return clusters;
}

struct Hash {
    std::size_t operator()(const Mesh::Triangle& t) const
    {
        std::uint64_t hash = t[0];
        for (const std::uint32_t corner : {t[1], t[2]})
            hash = hash * 0x9E3779B97F4A7C15ULL + corner;
        return static_cast<std::size_t>(hash ^ (hash >> 29U));
    }
};

/// The triangles that keep three corners, each once.
std::vector<Mesh::Triangle> trianglesOf(const Mesh& mesh, const Clusters& clusters)
{
    std::vector<Mesh::Triangle> triangles;
    std::unordered_set<Mesh::Triangle, Hash> seen;
    for (const auto& [a, b, c] : mesh.triangles) {
        Mesh::Triangle triangle{clusters.of[a], clusters.of[b], clusters.of[c]};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
            continue;
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        if (seen.insert(triangle).second)
            triangles.push_back(triangle);
    }
    return triangles;
}

/// Triangles that were folded over while corners moved would be taken for the surface's other side, which is dark.
void turnTowardsNormals(Mesh& mesh)
{
    for (auto& [a, b, c] : mesh.triangles) {
        const Vec3d own = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
        if (dot(own, mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) < 0.0)
            std::swap(b, c);
    }
}

Mesh meshOf(const Mesh& mesh, const Clusters& clusters, std::vector<Mesh::Triangle> triangles)
{
    Mesh coarse;
    coarse.name = mesh.name;
    coarse.placement = mesh.placement;
    coarse.triangles = std::move(triangles);
    coarse.positions.resize(clusters.count);
    coarse.normals.resize(clusters.count);
    std::vector<double> members(clusters.count, 0.0);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        coarse.positions[clusters.of[i]] += mesh.positions[i];
        coarse.normals[clusters.of[i]] += mesh.normals[i];
        members[clusters.of[i]] += 1.0;
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
        coarse.positions[i] = coarse.positions[i] / members[i];
        coarse.normals[i] = normalized(coarse.normals[i]); // those of one face of the cube cannot cancel
    }
    turnTowardsNormals(coarse);
    return coarse;
}

} // namespace

Mesh clustered(const Mesh& mesh, std::size_t mostTriangles)
{
    // About two triangles for each cluster, and a surface as large as the sphere's meets some 5 n^2 of n^3 cells.
    double cells = std::clamp(std::sqrt(static_cast<double>(mostTriangles) / 10.0), 1.0, 1e6);
    if (mesh.triangles.size() <= mostTriangles)
        cells = 1e6; // equal vertices alone become one
    for (;;) {
        const Clusters clusters = clustersOf(mesh, static_cast<int>(cells));
        std::vector<Mesh::Triangle> triangles = trianglesOf(mesh, clusters);
        if (triangles.size() <= mostTriangles || cells <= 1.0)
            return meshOf(mesh, clusters, std::move(triangles));
        const double shrink = std::sqrt(static_cast<double>(mostTriangles) / static_cast<double>(triangles.size()));
        cells = std::max(1.0, std::floor(cells * std::min(0.95, shrink)));
    }
}

} // namespace reflectance
