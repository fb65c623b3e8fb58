// From shaded samples to pixels: the mean over each pixel's grid of samples, the background where nothing was met.
#include "core/base/check.h"
#include "core/render/cpu/background.h"
#include "core/render/cpu/row_band.h"
#include "core/render/cpu/sample_shader.h"

#include <algorithm>
#include <tbb/parallel_for.h>

namespace reflectance {
namespace {

/// A run of pixels that one thread shades; fixed, so that a picture does not depend on the number of threads.
constexpr std::size_t pixelsPerTask = 512;

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

/// Writes the means of a run of pixels: firstPixel of the band, which starts `bandOffset` pixels into the picture.
template <class T>
void finishPixels(const ViewSamples& samples, const BackgroundSampler& background, std::size_t bandOffset,
                  std::size_t firstPixel, std::span<const Vec3<T>> sums, Image& image)
{
    const int perPixel = samples.settings.samplesPerAxis * samples.settings.samplesPerAxis;
    const T weight = T(1) / static_cast<T>(perPixel);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const std::size_t first = samples.firstOfPixel[firstPixel + i];
        const std::size_t last = samples.firstOfPixel[firstPixel + i + 1];
        const std::size_t pixel = bandOffset + firstPixel + i;
        const Vec3<T> mean = (sums[i] + Vec3<T>(background.sum(samples, first, last, pixel))) * weight;
        image.rgb[3 * pixel] = static_cast<float>(mean.x);
        image.rgb[3 * pixel + 1] = static_cast<float>(mean.y);
        image.rgb[3 * pixel + 2] = static_cast<float>(mean.z);
        image.coverage[pixel] = static_cast<float>(static_cast<int>(last - first)) / static_cast<float>(perPixel);
    }
}

template <class T>
void shadeWith(const Kernel<T>& kernel, const ViewSamples& samples, RowBand band, const Scene& scene, Stretch stretch,
               Image& image)
{
    const SampleShader<T> shader(samples, scene, kernel);
    const BackgroundSampler background(scene, samples.settings);
    const std::size_t bandOffset = Image::pixelCount(image.width, band.first);
    const std::size_t pixels = Image::pixelCount(image.width, band.rows);
    const std::size_t tasks = (pixels + pixelsPerTask - 1) / pixelsPerTask;
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
        if (stretch.cancelled())
            return;
        const std::size_t first = task * pixelsPerTask;
        std::array<Vec3<T>, pixelsPerTask> buffer{};
        const auto sums = std::span(buffer).first(std::min(pixelsPerTask, pixels - first));
        sumSamples<T>(samples, shader, first, sums);
        finishPixels<T>(samples, background, bandOffset, first, sums, image);
        stretch.advance(1.0 / static_cast<double>(tasks));
    });
}

} // namespace

void shadeBand(const ViewSamples& samples, RowBand band, const Scene& scene, Precision precision, Stretch stretch,
               Image& image)
{
    CHECK_LT(static_cast<int>(precision), static_cast<int>(Precision::Glsl));
    const Model& model = modelOf(scene);
    if (precision == Precision::Double)
        shadeWith(model.exact, samples, band, scene, stretch, image);
    else
        shadeWith(precision == Precision::Float ? model.single : model.lanes, samples, band, scene, stretch, image);
}

} // namespace reflectance
