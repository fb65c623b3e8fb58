#include "core/study/goniometer/tiled_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

constexpr double margin = 0.01;  ///< of the surroundings kept beside the period
constexpr double overlap = 1e-4; ///< how far beyond its period a ray looks: floats must not slip between two periods
constexpr int mostPeriods = 100000;

double untilSide(double position, double direction, double size)
{
    if (direction > 0.0)
        return std::max(0.0, (size - position) / direction);
    return direction < 0.0 ? std::max(0.0, position / -direction) : std::numeric_limits<double>::infinity();
}

/// Back into 0 .. size; facets are met up to `overlap` beyond it.
double inPeriod(double position, double size)
{
    if (position < 0.0)
        return position + size;
    return position > size ? position - size : position;
}

std::vector<Vec3d> normalsOf(const Mesh& mesh)
{
    std::vector<Vec3d> normals;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Vec3d& a = mesh.positions[t[0]];
        normals.push_back(normalized(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)));
    }
    return normals;
}

} // namespace

TiledRays::TiledRays(const Patch& patch)
    : width_(patch.width), depth_(patch.depth), scene_(withSurroundings(patch, margin)),
      normals_(normalsOf(scene_.mesh()))
{
    const auto [low, high] = std::minmax_element(patch.positions.begin(), patch.positions.end(),
                                                 [](const Vec3d& a, const Vec3d& b) { return a.z < b.z; });
    top_ = high->z + 1e-3;
    bottom_ = low->z - 1e-3;
}

void TiledRays::trace(std::span<TiledRay> rays) const
{
    for (std::size_t first = 0; first < rays.size(); first += 8)
        traceEight(rays.subspan(first, std::min<std::size_t>(8, rays.size() - first)));
}

void TiledRays::traceEight(std::span<TiledRay> rays) const
{
    SegmentPacket packet;
    std::array<double, 8> along{}; // to the end of this period
    std::size_t going = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].end = TiledRay::End::Lost;
        packet.active[i] = rays[i].active;
        going += rays[i].active ? 1 : 0;
    }
    for (int period = 0; going > 0 && period < mostPeriods; ++period) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const TiledRay& ray = rays[i];
            packet.origins[i] = ray.P;
            packet.directions[i] = ray.d;
            along[i] = std::min(untilSide(ray.P.x, ray.d.x, width_), untilSide(ray.P.y, ray.d.y, depth_));
            packet.reach[i] = std::min(along[i], untilSide(ray.P.z - bottom_, ray.d.z, top_ - bottom_)) + overlap;
        }
        const auto triangles = scene_.firstTriangles(packet);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!packet.active[i])
                continue;
            const bool isMet = triangles[i] != RayScene::nothing;
            if (isMet)
                meet(rays[i], triangles[i]);
            if (isMet || !wrapped(rays[i], along[i])) {
                packet.active[i] = false;
                --going;
            }
        }
    }
}

void TiledRays::meet(TiledRay& ray, std::uint32_t triangle) const
{
    const Vec3d& n = normals_[triangle];
    const double approach = dot(n, ray.d);
    if (approach == 0.0)
        return; // seen edge on, by rounding: it stays lost
    const Vec3d& corner = scene_.mesh().positions[scene_.mesh().triangles[triangle][0]];
    const Vec3d P = ray.P + std::max(0.0, dot(n, corner - ray.P) / approach) * ray.d;
    ray.P = {inPeriod(P.x, width_), inPeriod(P.y, depth_), P.z};
    ray.n = approach < 0.0 ? n : -n;
    ray.end = TiledRay::End::Facet;
}

/// On to the next period; false where the ray leaves the layer that holds facets before.
bool TiledRays::wrapped(TiledRay& ray, double along) const
{
    const double z = ray.P.z + along * ray.d.z;
    if (!(z < top_) || !(z > bottom_) || !std::isfinite(along)) {
        ray.end = ray.d.z > 0.0 ? TiledRay::End::Sky : TiledRay::End::Lost;
        return false;
    }
    const bool acrossX = untilSide(ray.P.x, ray.d.x, width_) <= along;
    const bool acrossY = untilSide(ray.P.y, ray.d.y, depth_) <= along;
    ray.P = {acrossX ? (ray.d.x > 0.0 ? 0.0 : width_) : ray.P.x + along * ray.d.x,
             acrossY ? (ray.d.y > 0.0 ? 0.0 : depth_) : ray.P.y + along * ray.d.y, z};
    return true;
}

} // namespace reflectance
