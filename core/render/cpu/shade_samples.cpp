// Shades every sample of every pixel by itself.
#include "core/base/check.h"
#include "core/reflectance/viewer.h"
#include "core/render/cpu/pixel_runs.h"
#include "core/render/cpu/sample_shader.h"
#include "core/scene/requirements.h"

#include <algorithm>

namespace reflectance {
namespace {

/// Sums the radiance of each pixel's samples, pixels first .. first + sums.size(), in T.
template <class T>
void sumSamples(const ViewSamples& samples, const SampleShader<T>& shader, std::size_t firstPixel,
                std::span<Vec3<T>> sums)
{
    ShadeBlock<T> block;
    const auto offsets = std::span(samples.firstOfPixel).subspan(firstPixel, sums.size() + 1);
    std::size_t pixel = 0;
    for (std::size_t first = offsets.front(); first < offsets.back(); first += blockSize) {
        const std::size_t count = std::min<std::size_t>(blockSize, offsets.back() - first);
        shader.shade(first, count, block);
        for (std::size_t i = 0; i < count; ++i) {
            while (first + i >= offsets[pixel + 1])
                ++pixel;
            sums[pixel] += block.sum[i];
        }
    }
}

template <class T>
void shadeWith(const Kernel<T>& kernel, const RequiredModel& required, const ViewSamples& samples, RowBand band,
               const Scene& scene, Stretch stretch, Image& image)
{
    const bool viewer = required.form.facing || looksAtViewer(required.model->text);
    const SampleShader<T> shader(samples, scene, kernel, required.values, viewer);
    const auto sum = [&](std::size_t first, std::span<Vec3<T>> sums) { sumSamples<T>(samples, shader, first, sums); };
    shadePixelRuns<T>(samples, band, scene, stretch, sum, image);
}

} // namespace

void shadeBand(const ViewSamples& samples, RowBand band, const Scene& scene, const Arithmetic& arithmetic,
               Stretch stretch, Image& image)
{
    CHECK_LT(static_cast<int>(arithmetic.precision), static_cast<int>(Precision::Glsl));
    const RequiredModel required = requiredSurface(scene, arithmetic);
    const bool otherLobe = arithmetic.lobe != LobeForm::Conditioned && required.model->text.usesLobe;
    const Kernels& kernels = otherLobe ? required.model->with(arithmetic.lobe) : required.model->with(required.form);
    if (arithmetic.precision == Precision::Double)
        shadeWith(kernels.exact, required, samples, band, scene, stretch, image);
    else
        shadeWith(arithmetic.precision == Precision::Float ? kernels.single : kernels.lanes, required, samples, band,
                  scene, stretch, image);
}

} // namespace reflectance
