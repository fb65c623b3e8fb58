// Pixels from sums of samples: runs of pixels are worked on in parallel, each pixel is the mean over its grid of
// samples, and where nothing was met the background shows.
#pragma once

#include "core/render/cpu/background.h"
#include "core/render/cpu/in_parallel.h"
#include "core/render/cpu/row_band.h"

#include <algorithm>
#include <array>
#include <span>

namespace reflectance {

/// A run of pixels that one thread shades; fixed, so that a picture does not depend on the number of threads.
constexpr std::size_t pixelsPerTask = 512;

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

/// Fills a band of the picture. `sumSamples(firstPixel, sums)` adds the radiance of the samples of the band's pixels
/// firstPixel .. firstPixel + sums.size(); it is called from several threads.
template <class T, class SumSamples>
void shadePixelRuns(const ViewSamples& samples, RowBand band, const Scene& scene, Stretch stretch,
                    const SumSamples& sumSamples, Image& image)
{
    const BackgroundSampler background(scene, samples.settings);
    const std::size_t bandOffset = Image::pixelCount(image.width, band.first);
    const std::size_t pixels = Image::pixelCount(image.width, band.rows);
    const std::size_t tasks = (pixels + pixelsPerTask - 1) / pixelsPerTask;
    inParallel(std::size_t{0}, tasks, [&](std::size_t task) {
        if (stretch.cancelled())
            return;
        const std::size_t first = task * pixelsPerTask;
        std::array<Vec3<T>, pixelsPerTask> buffer{};
        const auto sums = std::span(buffer).first(std::min(pixelsPerTask, pixels - first));
        sumSamples(first, sums);
        finishPixels<T>(samples, background, bandOffset, first, sums, image);
        stretch.advance(1.0 / static_cast<double>(tasks));
    });
}

} // namespace reflectance
