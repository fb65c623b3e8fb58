// Pixels from sums of samples: runs of pixels are worked on in parallel, each pixel is the mean over its grid of
// samples, and where nothing was met the background shows.
#pragma once

#include "core/image/image.h"
#include "core/render/cpu/background.h"
#include "core/render/cpu/in_parallel.h"
#include "core/render/cpu/stretch.h"

#include <algorithm>
#include <array>
#include <span>

namespace reflectance {

/// A run of pixels that one thread shades; fixed, so that a picture does not depend on the number of threads.
constexpr std::size_t pixelsPerTask = 512;

/// Writes means of pixels. What depends on the number of covered samples alone is computed once.
template <class T> class PixelWriter {
public:
    /// The scene must outlive the writer.
    PixelWriter(const Scene& scene, const RenderSettings& settings)
        : background_(scene, settings), perPixel_(settings.samplesPerAxis * settings.samplesPerAxis)
    {
        for (int covered = 0; covered <= perPixel_; ++covered) {
            const auto i = static_cast<std::size_t>(covered);
            plain_[i] = Vec3<T>(background_.plainSum(perPixel_ - covered));
            coverage_[i] = static_cast<float>(covered) / static_cast<float>(perPixel_);
        }
    }

    /// From `pixel` of the picture on, whose samples are those of `firstPixel` on.
    void write(const ViewSamples& samples, std::size_t firstPixel, std::span<const Vec3<T>> sums, std::size_t pixel,
               Image& image) const
    {
        const T weight = T(1) / static_cast<T>(perPixel_);
        const bool empty = samples.firstOfPixel[firstPixel] == samples.firstOfPixel[firstPixel + sums.size()];
        if (empty && background_.isPlain(0)) {
            fill((Vec3<T>() + plain_[0]) * weight, pixel, sums.size(), image);
            return;
        }
        for (std::size_t i = 0; i < sums.size(); ++i, ++pixel) {
            const std::size_t first = samples.firstOfPixel[firstPixel + i];
            const std::size_t last = samples.firstOfPixel[firstPixel + i + 1];
            const std::size_t covered = last - first;
            const Vec3<T> behind = background_.isPlain(covered)
                                       ? plain_[covered]
                                       : Vec3<T>(background_.environmentSum(samples, first, last, pixel));
            const Vec3<T> mean = (sums[i] + behind) * weight;
            image.rgb[3 * pixel] = static_cast<float>(mean.x);
            image.rgb[3 * pixel + 1] = static_cast<float>(mean.y);
            image.rgb[3 * pixel + 2] = static_cast<float>(mean.z);
            image.coverage[pixel] = coverage_[covered];
        }
    }

private:
    /// Pixels that nothing covers.
    static void fill(const Vec3<T>& color, std::size_t pixel, std::size_t count, Image& image)
    {
        const Vec3f c(color);
        float* rgb = &image.rgb[3 * pixel];
        for (std::size_t i = 0; i < count; ++i, rgb += 3) {
            rgb[0] = c.x;
            rgb[1] = c.y;
            rgb[2] = c.z;
        }
        std::fill_n(&image.coverage[pixel], count, 0.0F);
    }

    static constexpr std::size_t mostSamples = 64;

    BackgroundSampler background_;
    int perPixel_;
    std::array<Vec3<T>, mostSamples + 1> plain_; ///< what the uncovered samples show, by the number of covered ones
    std::array<float, mostSamples + 1> coverage_{};
};

/// Fills the picture. `sumSamples(firstPixel, sums)` adds the radiance of the samples of pixels firstPixel .. firstPixel +
/// sums.size(); it is called from several threads.
template <class T, class SumSamples>
void shadePixelRuns(const ViewSamples& samples, const Scene& scene, Stretch stretch, const SumSamples& sumSamples,
                    Image& image)
{
    const PixelWriter<T> writer(scene, samples.settings);
    const std::size_t pixels = image.pixels();
    const std::size_t tasks = (pixels + pixelsPerTask - 1) / pixelsPerTask;
    inParallel(std::size_t{0}, tasks, [&](std::size_t task) {
        if (stretch.cancelled())
            return;
        const std::size_t first = task * pixelsPerTask;
        std::array<Vec3<T>, pixelsPerTask> buffer{};
        const auto sums = std::span(buffer).first(std::min(pixelsPerTask, pixels - first));
        sumSamples(first, sums);
        writer.write(samples, first, sums, first, image);
        stretch.advance(1.0 / static_cast<double>(tasks));
    });
}

} // namespace reflectance
