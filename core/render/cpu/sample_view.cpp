// Visibility: which triangle each sample meets (Embree), then where and with which normal (double).
#include "core/render/cpu/in_parallel.h"
#include "core/render/cpu/pixel_rays.h"
#include "core/render/cpu/ray_scene.h"
#include "core/render/cpu/row_band.h"
#include "core/render/cpu/surface_point.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr int tileSize = 32;

/// The triangle of every sample of a band, sample by sample within a pixel.
struct Hits {
    RowBand band;
    int width = 0;
    int perPixel = 0;
    std::vector<std::uint32_t> triangles;

    [[nodiscard]] std::size_t pixel(int x, int y) const
    {
        return static_cast<std::size_t>(y - band.first) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] std::uint32_t* samplesOf(int x, int y)
    {
        return &triangles[pixel(x, y) * static_cast<std::size_t>(perPixel)];
    }
};

/// Traces sample s of 4 x 2 pixels: neighbours share most of their way through Embree's tree.
void tracePixels(const RayScene& rays, const PixelRays& pixelRays, int left, int top, int s, RayPacket& packet,
                 Hits& hits)
{
    const auto inside = [&](int x, int y) { return x < hits.width && y < hits.band.first + hits.band.rows; };
    for (int i = 0; i < 8; ++i) {
        const int x = left + i % 4;
        const int y = top + i / 4;
        const auto ray = static_cast<std::size_t>(i);
        packet.active[ray] = inside(x, y);
    }
    pixelRays.throughBlock(left, top, s, packet.x, packet.y, packet.z);
    const auto triangles = rays.firstTriangles(packet);
    for (int i = 0; i < 8; ++i)
        if (packet.active[static_cast<std::size_t>(i)])
            hits.samplesOf(left + i % 4, top + i / 4)[s] = triangles[static_cast<std::size_t>(i)];
}

void traceTile(const RayScene& rays, const PixelRays& pixelRays, const Vec3d& eye, int left, int top, Hits& hits)
{
    RayPacket packet;
    packet.eye = eye;
    const int right = std::min(left + tileSize, hits.width);
    const int bottom = std::min(top + tileSize, hits.band.first + hits.band.rows);
    for (int s = 0; s < hits.perPixel; ++s)
        for (int y = top; y < bottom; y += 2)
            for (int x = left; x < right; x += 4)
                tracePixels(rays, pixelRays, x, y, s, packet, hits);
}

Hits traceBand(const RayScene& rays, const PixelRays& pixelRays, const Vec3d& eye, const RenderSettings& settings,
               RowBand band, Stretch stretch)
{
    const int perPixel = settings.samplesPerAxis * settings.samplesPerAxis;
    Hits hits{band, settings.width, perPixel, {}};
    hits.triangles.assign(Image::pixelCount(settings.width, band.rows) * static_cast<std::size_t>(perPixel),
                          RayScene::nothing);
    const int across = (settings.width + tileSize - 1) / tileSize;
    const int tiles = across * ((band.rows + tileSize - 1) / tileSize);
    inParallel(0, tiles, [&](int tile) {
        if (stretch.cancelled())
            return;
        traceTile(rays, pixelRays, eye, tile % across * tileSize, band.first + tile / across * tileSize, hits);
        stretch.advance(0.5 / tiles);
    });
    return hits;
}

/// Offsets of each pixel's samples among those that met the object.
std::vector<std::uint32_t> offsetsOf(const Hits& hits)
{
    const auto perPixel = static_cast<std::size_t>(hits.perPixel);
    std::vector<std::uint32_t> offsets(hits.triangles.size() / perPixel + 1, 0);
    for (std::size_t i = 0; i < hits.triangles.size(); ++i)
        offsets[i / perPixel + 1] += hits.triangles[i] != RayScene::nothing ? 1U : 0U;
    for (std::size_t pixel = 1; pixel < offsets.size(); ++pixel)
        offsets[pixel] += offsets[pixel - 1];
    return offsets;
}

void resize(ViewSamples& samples, std::size_t count)
{
    for (auto* numbers : {&samples.Px, &samples.Py, &samples.Pz, &samples.Nx, &samples.Ny, &samples.Nz})
        numbers->resize(count);
    samples.triangle.resize(count);
}

void storeRow(const Mesh& mesh, const PixelRays& pixelRays, Hits& hits, int y, ViewSamples& samples)
{
    std::size_t i = samples.firstOfPixel[hits.pixel(0, y)];
    for (int x = 0; x < hits.width; ++x) {
        const std::uint32_t* triangles = hits.samplesOf(x, y);
        for (int s = 0; s < hits.perPixel; ++s) {
            if (triangles[s] == RayScene::nothing)
                continue;
            const auto [P, N] = surfacePoint(mesh, triangles[s], samples.eye, pixelRays.throughSample(x, y, s));
            samples.triangle[i] = triangles[s];
            samples.Px[i] = P.x;
            samples.Py[i] = P.y;
            samples.Pz[i] = P.z;
            samples.Nx[i] = N.x;
            samples.Ny[i] = N.y;
            samples.Nz[i] = N.z;
            ++i;
        }
    }
}

} // namespace

ViewSamples sampleBand(const RayScene& rays, const Camera& camera, const RenderSettings& settings, RowBand band,
                       Stretch stretch)
{
    const PixelRays pixelRays(camera, settings);
    Hits hits = traceBand(rays, pixelRays, camera.eye, settings, band, stretch);
    ViewSamples samples;
    samples.settings = settings;
    samples.eye = camera.eye;
    samples.firstOfPixel = offsetsOf(hits);
    resize(samples, samples.firstOfPixel.back());
    inParallel(band.first, band.first + band.rows, [&](int y) {
        if (!stretch.cancelled())
            storeRow(rays.mesh(), pixelRays, hits, y, samples);
        stretch.advance(0.5 / band.rows);
    });
    return samples;
}

} // namespace reflectance
