// Which triangle each sample of a tile meets (Embree), and where and with which normal (double).
#pragma once

#include "core/render/cpu/pixel_rays.h"
#include "core/render/cpu/ray_scene.h"
#include "core/render/cpu/tiles.h"
#include "core/render/view_samples.h"

namespace reflectance {

/// Traces packets of `packetSize` (8 or 16) neighbours, which share most of their way through Embree's tree.
void traceTile(const RayScene& rays, const PixelRays& pixelRays, const RenderSettings& settings, const Tile& tile,
               int packetSize, TileHits& hits);

/// How many of a pixel's samples met something, (x, y) counted from the tile's corner.
[[nodiscard]] std::uint32_t samplesMet(const TileHits& hits, int samplesPerAxis, int x, int y);

/// Room for the samples of any tile, to be used again: columns keep their length, `firstOfPixel` says what is in them.
class TileSamples {
public:
    TileSamples(const RenderSettings& settings, const Vec3d& eye);

    /// The samples that met something, `firstOfPixel` speaking of the tile's pixels.
    const ViewSamples& find(const Mesh& mesh, const PixelRays& pixelRays, const Tile& tile, const TileHits& hits);

private:
    [[nodiscard]] std::size_t collect(const Tile& tile, const TileHits& hits);

    ViewSamples samples_;
    std::array<double, TileHits::samples> x_, y_; ///< image points
};

} // namespace reflectance
