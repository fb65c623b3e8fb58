#include "core/render/cpu/tile_tracer.h"

#include "core/render/cpu/lane_work.h"

#include <algorithm>
#include <embree3/rtcore.h>
#include <limits>

namespace reflectance {
namespace {

/// Embree's packets by their number of rays, all of one shape.
template <int N> struct PacketOf;
template <> struct PacketOf<8> {
    using Rays = RTCRayHit8;
    static constexpr auto intersect = rtcIntersect8;
};
template <> struct PacketOf<16> {
    using Rays = RTCRayHit16;
    static constexpr auto intersect = rtcIntersect16;
};

/// Four columns and N / 4 rows of samples. What is the same for all packets is written once.
template <int N> class Packet {
public:
    Packet()
    {
        for (std::size_t i = 0; i < N; ++i) {
            rays_.ray.tnear[i] = 0.0F;
            rays_.ray.time[i] = 0.0F;
            rays_.ray.mask[i] = 0xFFFFFFFF;
            rays_.ray.id[i] = 0;
            rays_.ray.flags[i] = 0;
        }
        rtcInitIntersectContext(&context_);
        context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    }

    [[nodiscard]] RayColumns columns()
    {
        return {rays_.ray.org_x, rays_.ray.org_y, rays_.ray.org_z, rays_.ray.dir_x,
                rays_.ray.dir_y, rays_.ray.dir_z, valid_};
    }

    void trace(RTCScene scene)
    {
        for (std::size_t i = 0; i < N; ++i) {
            rays_.ray.tfar[i] = std::numeric_limits<float>::infinity();
            rays_.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        PacketOf<N>::intersect(valid_, scene, &context_, &rays_);
    }

    [[nodiscard]] std::uint32_t triangle(std::size_t i) const
    {
        return rays_.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? rays_.hit.primID[i] : RayScene::nothing;
    }

private:
    alignas(64) typename PacketOf<N>::Rays rays_;
    alignas(64) int valid_[N];
    RTCIntersectContext context_;
};

/// Image points of a tile's columns or rows; the last is repeated, so that packets are full.
void placeGrid(const PixelRays& pixelRays, int firstPixel, int pixels, int perPixel,
               std::array<double, tileEdge>& places)
{
    const int count = pixels * perPixel;
    for (int i = 0; i < tileEdge; ++i) {
        const int sample = std::min(i, count - 1);
        places[static_cast<std::size_t>(i)] = pixelRays.place(firstPixel + sample / perPixel, sample % perPixel);
    }
}

/// False only where every ray of a tile passes the mesh's sphere: where the cone about the tile's corners, seen from the
/// middle, and that about the sphere are apart.
bool mayMeet(const RayScene& rays, const PixelRays& pixelRays, int columns, int rows, const TileHits& hits)
{
    const Vec3d& eye = pixelRays.frame().eye;
    const double distance = length(eye);
    const double reach = 1.01 * rays.radius(); // more than the rays' own test allows
    if (!(distance > reach))
        return true;
    const double left = hits.xs[0], right = hits.xs[static_cast<std::size_t>(columns - 1)];
    const double top = hits.ys[0], bottom = hits.ys[static_cast<std::size_t>(rows - 1)];
    const Vec3d middle = pixelRays.through(0.5 * (left + right), 0.5 * (top + bottom));
    double smallest = 1.0; // cosine
    for (const double x : {left, right})
        for (const double y : {top, bottom})
            smallest = std::min(smallest, dot(middle, pixelRays.through(x, y)));
    const double away = std::acos(std::clamp(-dot(middle, eye) / distance, -1.0, 1.0));
    return !(away > std::acos(std::clamp(smallest, -1.0, 1.0)) + std::asin(reach / distance));
}

template <int N>
void tracePackets(const RayScene& rays, const PixelRays& pixelRays, int columns, int rows, TileHits& hits)
{
    constexpr int height = N / 4;
    const LaneWork& lanes = laneWork();
    Packet<N> packet;
    bool any = false;
    for (int row = 0; row < rows; row += height)
        for (int column = 0; column < columns; column += 4) {
            const auto x = static_cast<std::size_t>(column);
            const auto y = static_cast<std::size_t>(row);
            const bool near =
                lanes.aim(pixelRays.frame(), rays.radius(), &hits.xs[x], &hits.ys[y], height, packet.columns());
            if (near)
                packet.trace(rays.embree());
            for (std::size_t i = 0; i < N; ++i) {
                const std::uint32_t triangle = near ? packet.triangle(i) : RayScene::nothing;
                hits.triangles[(y + i / 4) * tileEdge + x + i % 4] = triangle;
                any = any || triangle != RayScene::nothing;
            }
        }
    hits.any = any;
}

} // namespace

void traceTile(const RayScene& rays, const PixelRays& pixelRays, const RenderSettings& settings, const Tile& tile,
               int packetSize, TileHits& hits)
{
    const int k = settings.samplesPerAxis;
    placeGrid(pixelRays, tile.left, tile.width, k, hits.xs);
    placeGrid(pixelRays, tile.top, tile.height, k, hits.ys);
    hits.any = false;
    if (!mayMeet(rays, pixelRays, tile.width * k, tile.height * k, hits))
        return;
    const auto trace = packetSize == 16 ? tracePackets<16> : tracePackets<8>;
    trace(rays, pixelRays, tile.width * k, tile.height * k, hits);
}

std::uint32_t samplesMet(const TileHits& hits, int samplesPerAxis, int x, int y)
{
    std::uint32_t met = 0;
    for (int row = y * samplesPerAxis; row < (y + 1) * samplesPerAxis; ++row)
        for (int column = x * samplesPerAxis; column < (x + 1) * samplesPerAxis; ++column)
            met += hits.at(column, row) != RayScene::nothing ? 1U : 0U;
    return met;
}

TileSamples::TileSamples(const RenderSettings& settings, const Vec3d& eye)
{
    samples_.settings = settings;
    samples_.eye = eye;
    samples_.firstOfPixel.resize(TileHits::samples + 1);
    samples_.triangle.resize(TileHits::samples);
    for (auto* numbers : {&samples_.Px, &samples_.Py, &samples_.Pz, &samples_.Nx, &samples_.Ny, &samples_.Nz})
        numbers->resize(TileHits::samples);
}

/// Pixel by pixel, and in each row by row of its samples.
std::size_t TileSamples::collect(const Tile& tile, const TileHits& hits)
{
    if (!hits.any) {
        std::fill(samples_.firstOfPixel.begin(), samples_.firstOfPixel.end(), 0U);
        return 0;
    }
    const int k = samples_.settings.samplesPerAxis;
    std::size_t pixel = 0;
    std::size_t count = 0;
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            samples_.firstOfPixel[pixel++] = static_cast<std::uint32_t>(count);
            for (int row = y * k; row < (y + 1) * k; ++row)
                for (int column = x * k; column < (x + 1) * k; ++column) {
                    // Written for each, counted if it met something: no branch that nobody could foresee.
                    const std::uint32_t triangle = hits.at(column, row);
                    samples_.triangle[count] = triangle;
                    x_[count] = hits.xs[static_cast<std::size_t>(column)];
                    y_[count] = hits.ys[static_cast<std::size_t>(row)];
                    count += triangle != RayScene::nothing ? 1U : 0U;
                }
        }
    samples_.firstOfPixel[pixel] = static_cast<std::uint32_t>(count);
    return count;
}

const ViewSamples& TileSamples::find(const Mesh& mesh, const PixelRays& pixelRays, const Tile& tile,
                                     const TileHits& hits)
{
    const std::size_t count = collect(tile, hits);
    laneWork().find(mesh, pixelRays.frame(), {count, x_.data(), y_.data(), samples_.triangle.data()},
                    {samples_.Px.data(), samples_.Py.data(), samples_.Pz.data(), samples_.Nx.data(), samples_.Ny.data(),
                     samples_.Nz.data()});
    return samples_;
}

} // namespace reflectance
