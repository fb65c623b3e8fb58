#include "core/render/cpu/cpu_renderer.h"

#include "core/base/check.h"
#include "core/render/cpu/ray_scene.h"
#include "core/render/cpu/row_band.h"

#include <algorithm>

namespace reflectance {
namespace {

/// So many samples, at 56 bytes each, are held at a time: a picture of 1024 x 1024 with 2 x 2 samples in one go.
constexpr int samplesPerBand = 1 << 22;

int rowsPerBand(const RenderSettings& settings)
{
    const int perRow = settings.width * settings.samplesPerAxis * settings.samplesPerAxis;
    return std::clamp(samplesPerBand / perRow, 1, settings.height);
}

} // namespace

std::shared_ptr<const RayScene> makeRayScene(std::shared_ptr<const Mesh> mesh)
{
    return std::make_shared<RayScene>(std::move(mesh));
}

ViewSamples sampleView(const RayScene& rays, const Camera& camera, const RenderSettings& settings, Progress* progress)
{
    return sampleBand(rays, camera, settings, {0, settings.height}, {progress});
}

Image shadeSamples(const ViewSamples& samples, const Scene& scene, const Arithmetic& arithmetic, Progress* progress)
{
    Image image(samples.settings.width, samples.settings.height);
    CHECK_EQ(samples.firstOfPixel.size(), image.pixels() + 1);
    shadeBand(samples, {0, image.height}, scene, arithmetic, {progress}, image);
    return image;
}

Image renderOnCpu(const Scene& scene, const RenderSettings& settings, const Arithmetic& arithmetic, Progress* progress,
                  double share)
{
    const RayScene rays(scene.mesh);
    Image image(settings.width, settings.height);
    const int step = rowsPerBand(settings);
    for (int row = 0; row < settings.height && !(progress != nullptr && progress->cancel); row += step) {
        const RowBand band{row, std::min(step, settings.height - row)};
        const Stretch half{progress, 0.5 * share * band.rows / settings.height};
        shadeBand(sampleBand(rays, scene.camera, settings, band, half), band, scene, arithmetic, half, image);
    }
    return image;
}

} // namespace reflectance
