#include "core/study/probe/triangle_runs.h"

#include <algorithm>
#include <limits>
#include <mutex>

namespace reflectance {

TriangleRuns::TriangleRuns(const Mesh& mesh) : triangles_(mesh.triangles.size())
{
    spheres_.reserve(triangles_ / runLength + 1);
    for (std::size_t first = 0; first < triangles_; first += runLength)
        spheres_.push_back(around(mesh, first, std::min(first + runLength, triangles_)));
}

/// About the middle of their box.
TriangleRuns::Sphere TriangleRuns::around(const Mesh& mesh, std::size_t first, std::size_t last)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3d low(infinity);
    Vec3d high(-infinity);
    const auto eachCorner = [&](const auto& visit) {
        for (std::size_t i = first; i < last; ++i)
            for (const std::uint32_t corner : mesh.triangles[i])
                visit(mesh.positions[corner]);
    };
    eachCorner([&](const Vec3d& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    });
    Sphere sphere{0.5 * (low + high), 0.0};
    eachCorner([&](const Vec3d& p) { sphere.radius = std::max(sphere.radius, length(p - sphere.centre)); });
    return sphere;
}

std::shared_ptr<const TriangleRuns> runsOf(const std::shared_ptr<const Mesh>& mesh)
{
    static std::mutex mutex;
    static std::weak_ptr<const Mesh> of;
    static std::shared_ptr<const TriangleRuns> runs;
    const std::lock_guard lock(mutex);
    if (runs == nullptr || of.lock() != mesh) {
        runs = std::make_shared<const TriangleRuns>(*mesh);
        of = mesh;
    }
    return runs;
}

} // namespace reflectance
