// Visibility: which triangle each sample meets (Embree), then where and with which normal (double).
#include "core/image/image.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/render/cpu/in_parallel.h"
#include "core/render/cpu/stretch.h"
#include "core/render/cpu/tile_tracer.h"

#include <algorithm>
#include <memory>
#include <tbb/enumerable_thread_specific.h>

namespace reflectance {
namespace {

/// Not written before they are traced.
using AllHits = std::unique_ptr<TileHits[]>;

/// Counts in `counts`, one for each pixel, how many of its samples met something.
void countSamples(const TileHits& hits, const Tile& tile, const RenderSettings& settings, std::uint32_t* counts)
{
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const std::size_t pixel =
                Image::pixelCount(settings.width, tile.top + y) + static_cast<std::size_t>(tile.left + x);
            counts[pixel] = samplesMet(hits, settings.samplesPerAxis, x, y);
        }
}

/// From counts, each one place to the right, to the offsets of each pixel's samples.
void sumUp(std::vector<std::uint32_t>& offsets)
{
    for (std::size_t pixel = 1; pixel < offsets.size(); ++pixel)
        offsets[pixel] += offsets[pixel - 1];
}

/// Makes room for the samples, several columns at a time: it is the first touch of much memory.
void resize(ViewSamples& samples, std::size_t count)
{
    std::vector<double>* const columns[] = {&samples.Px, &samples.Py, &samples.Pz,
                                            &samples.Nx, &samples.Ny, &samples.Nz};
    inParallel(0, 7, [&](int i) {
        if (i < 6)
            columns[i]->resize(count);
        else
            samples.triangle.resize(count);
    });
}

/// Copies a row of a tile to its place among all samples.
void storeRow(const ViewSamples& from, const Tile& tile, int y, ViewSamples& to)
{
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.width);
    const std::size_t first = from.firstOfPixel[row];
    const std::size_t last = from.firstOfPixel[row + static_cast<std::size_t>(tile.width)];
    const std::size_t place =
        to.firstOfPixel[Image::pixelCount(to.settings.width, tile.top + y) + static_cast<std::size_t>(tile.left)];
    const auto copy = [&](const auto& source, auto& target) {
        std::copy(source.data() + first, source.data() + last, target.data() + place);
    };
    copy(from.Px, to.Px);
    copy(from.Py, to.Py);
    copy(from.Pz, to.Pz);
    copy(from.Nx, to.Nx);
    copy(from.Ny, to.Ny);
    copy(from.Nz, to.Nz);
    copy(from.triangle, to.triangle);
}

} // namespace

ViewSamples sampleView(const RayScene& rays, const Camera& camera, const RenderSettings& settings, Progress* progress)
{
    const PixelRays pixelRays(camera, settings);
    const Tiles tiles(settings);
    const Stretch stretch{progress, 0.5 / tiles.count()};
    ViewSamples samples;
    samples.settings = settings;
    samples.eye = camera.eye;
    samples.firstOfPixel.resize(Image::pixelCount(settings.width, settings.height) + 1);
    const AllHits hits(new TileHits[static_cast<std::size_t>(tiles.count())]);
    inParallel(0, tiles.count(), [&](int i) {
        TileHits& its = hits[static_cast<std::size_t>(i)];
        its.any = false;
        if (!stretch.cancelled())
            traceTile(rays, pixelRays, settings, tiles[i], rays.packetSize(), its);
        if (its.any)
            countSamples(its, tiles[i], settings, samples.firstOfPixel.data() + 1);
        stretch.advance(1.0);
    });
    sumUp(samples.firstOfPixel);
    resize(samples, samples.firstOfPixel.back());
    tbb::enumerable_thread_specific<TileSamples> room(settings, camera.eye);
    inParallel(0, tiles.count(), [&](int i) {
        const Tile tile = tiles[i];
        const TileHits& its = hits[static_cast<std::size_t>(i)];
        if (its.any && !stretch.cancelled()) {
            const ViewSamples& found = room.local().find(rays.mesh(), pixelRays, tile, its);
            for (int y = 0; y < tile.height; ++y)
                storeRow(found, tile, y, samples);
        }
        stretch.advance(1.0);
    });
    return samples;
}

} // namespace reflectance
