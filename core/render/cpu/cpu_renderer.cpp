// The first frame, tile by tile: a tile's samples are shaded while they are in the cache, and are not kept.
#include "core/render/cpu/cpu_renderer.h"

#include "core/render/cpu/picture_shader.h"
#include "core/render/cpu/pixel_runs.h"
#include "core/render/cpu/tile_tracer.h"

#include <tbb/enumerable_thread_specific.h>

namespace reflectance {
namespace {

/// What all tiles share.
struct Frame {
    const RayScene& rays;
    const Scene& scene;
    RenderSettings settings;
    PixelRays pixelRays;
};

/// What a thread needs for a tile, to be used again for the next.
template <class T> struct Room {
    TileHits hits;
    TileSamples samples;
    std::array<Vec3<T>, TileHits::samples> sums;

    explicit Room(const Frame& frame) : samples(frame.settings, frame.scene.camera.eye) {}
};

template <class T>
void renderTile(const Frame& frame, const SampleShader<T>& shader, const PixelWriter<T>& writer, const Tile& tile,
                Room<T>& room, Image& image)
{
    traceTile(frame.rays, frame.pixelRays, frame.settings, tile, frame.rays.packetSize(), room.hits);
    const ViewSamples& samples = room.samples.find(frame.rays.mesh(), frame.pixelRays, tile, room.hits);
    const auto width = static_cast<std::size_t>(tile.width);
    const auto sums = std::span(room.sums).first(width * static_cast<std::size_t>(tile.height));
    std::fill(sums.begin(), sums.end(), Vec3<T>());
    sumSamples(samples, shader, 0, sums);
    for (int y = 0; y < tile.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * width;
        const std::size_t pixel = Image::pixelCount(image.width, tile.top + y) + static_cast<std::size_t>(tile.left);
        writer.write(samples, first, sums.subspan(first, width), pixel, image);
    }
}

} // namespace

std::shared_ptr<const RayScene> makeRayScene(std::shared_ptr<const Mesh> mesh)
{
    return std::make_shared<RayScene>(std::move(mesh));
}

std::shared_ptr<const RayScene> makeRayScene(std::shared_ptr<const Mesh> mesh, const RenderSettings& once)
{
    // Measured: of a million triangles the better tree takes 150 ms longer, and is won back by some forty million rays. Small
    // meshes have theirs in no time.
    constexpr std::size_t many = 100'000, raysPerTriangle = 16;
    const std::size_t triangles = mesh->triangles.size();
    const bool isForFew = triangles >= many && once.samples() < raysPerTriangle * triangles;
    return std::make_shared<RayScene>(std::move(mesh), isForFew ? RayScene::Tree::ForFew : RayScene::Tree::ForMany);
}

Image renderOnCpu(const RayScene& rays, const Scene& scene, const RenderSettings& settings,
                  const Arithmetic& arithmetic, Progress* progress, double share)
{
    Image image(settings.width, settings.height);
    const Frame frame{rays, scene, settings, PixelRays(scene.camera, settings)};
    const Tiles tiles(settings);
    const Stretch stretch{progress, share / tiles.count()};
    withShader(scene, arithmetic, [&]<class T>(const SampleShader<T>& shader) {
        const PixelWriter<T> writer(scene, settings);
        tbb::enumerable_thread_specific<Room<T>> room(frame);
        inParallel(0, tiles.count(), [&](int i) {
            if (stretch.cancelled())
                return;
            renderTile(frame, shader, writer, tiles[i], room.local(), image);
            stretch.advance(1.0);
        });
    });
    return image;
}

Image renderOnCpu(const Scene& scene, const RenderSettings& settings, const Arithmetic& arithmetic, Progress* progress,
                  double share)
{
    return renderOnCpu(*makeRayScene(scene.mesh, settings), scene, settings, arithmetic, progress, share);
}

} // namespace reflectance
