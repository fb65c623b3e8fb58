// Shades every sample of every pixel by itself.
#include "core/render/cpu/cpu_renderer.h"
#include "core/render/cpu/picture_shader.h"
#include "core/render/cpu/pixel_runs.h"

namespace reflectance {

Image shadeSamples(const ViewSamples& samples, const Scene& scene, const Arithmetic& arithmetic, Progress* progress)
{
    Image image(samples.settings.width, samples.settings.height);
    CHECK_EQ(samples.firstOfPixel.size(), image.pixels() + 1);
    withShader(scene, arithmetic, [&]<class T>(const SampleShader<T>& shader) {
        const auto sum = [&](std::size_t first, std::span<Vec3<T>> sums) { sumSamples(samples, shader, first, sums); };
        shadePixelRuns<T>(samples, scene, {progress}, sum, image);
    });
    return image;
}

} // namespace reflectance
