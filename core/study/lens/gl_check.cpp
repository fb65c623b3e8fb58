#include "core/study/lens/gl_check.h"

#include "core/study/lens/sensitivity.h"
#include "core/study/lens/thinned.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// GLSL cuts an exponential to 0 below the smallest normal number, 2^-126; what multiplies it afterwards, the light and the
/// height of a highlight, stays below 2^26.
constexpr double cut = 0x1p-100;

/// Rows of the grid that are examined at a time: few enough that a cancelled check ends at once.
constexpr std::ptrdiff_t rowsAtATime = 2;

void see(const GlPixel& pixel, GlCheck& check)
{
    ++check.pixels;
    check.beyond += pixel.ratio <= 1.0 ? 0 : 1;
    check.largestDifference = std::fmax(check.largestDifference, pixel.difference);
    if (check.pixels == 1 || pixel.ratio > check.worst.ratio)
        check.worst = pixel;
}

/// The channel nearest to its bound.
void judge(double drawn, double exact, double slope, GlPixel& pixel)
{
    const double bound = 64.0 * 0x1p-23 * slope + cut;
    const double difference = drawn == exact ? 0.0 : std::fabs(drawn - exact); // equal infinities are equal
    const double ratio = difference / bound;
    if (std::isnan(ratio) || ratio > pixel.ratio || pixel.bound == 0.0) {
        pixel.difference = std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
        pixel.bound = bound;
        pixel.ratio = std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio;
    }
}

/// What the samples first .. last of a pixel give together, and what was drawn.
GlPixel examined(const Sensitivity& found, std::size_t first, std::size_t last, const float* drawn)
{
    Vec3d exact;
    Vec3d slope;
    for (std::size_t i = first; i < last; ++i) {
        const Vec3d& value = found.value[i];
        exact += value;
        slope += found.all(i) + Vec3d(std::fabs(value.x), std::fabs(value.y), std::fabs(value.z));
    }
    const auto samples = static_cast<double>(last - first);
    GlPixel pixel;
    pixel.exact = exact / samples;
    pixel.drawn = {drawn[0], drawn[1], drawn[2]};
    judge(pixel.drawn.x, pixel.exact.x, slope.x / samples, pixel);
    judge(pixel.drawn.y, pixel.exact.y, slope.y / samples, pixel);
    judge(pixel.drawn.z, pixel.exact.z, slope.z / samples, pixel);
    return pixel;
}

/// Looks at the pixels where the columns and rows cross, but for those that the object covers in part or not at all.
void lookAt(const ViewSamples& samples, const Image& drawn, const Scene& scene, const std::vector<int>& columns,
            const std::vector<int>& rows, GlCheck& check)
{
    const auto whole = static_cast<std::uint32_t>(samples.settings.samplesPerAxis * samples.settings.samplesPerAxis);
    const ViewSamples few = crossings(samples, columns, rows);
    const Sensitivity found = sensitivityOf(few, scene);
    std::size_t crossing = 0;
    for (const int y : rows)
        for (const int x : columns) {
            const std::uint32_t first = few.firstOfPixel[crossing];
            const std::uint32_t last = few.firstOfPixel[++crossing];
            if (last - first != whole)
                continue;
            GlPixel pixel = examined(found, first, last, drawn.at(x, y));
            pixel.x = x;
            pixel.y = y;
            see(pixel, check);
        }
}

} // namespace

std::optional<GlCheck> checkGl(const ViewSamples& samples, const Image& drawn, const Scene& scene, std::size_t wanted,
                               const Progress& progress)
{
    const double perPixel = static_cast<double>(drawn.pixels()) / static_cast<double>(std::max<std::size_t>(1, wanted));
    const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(perPixel))));
    const std::vector<int> columns = middles(drawn.width, stride);
    const std::vector<int> rows = middles(drawn.height, stride);
    GlCheck check;
    for (auto row = rows.begin(); row != rows.end();) {
        if (progress.cancel)
            return std::nullopt;
        const auto next = row + std::min(rowsAtATime, rows.end() - row);
        lookAt(samples, drawn, scene, columns, std::vector<int>(row, next), check);
        row = next;
    }
    return check;
}

} // namespace reflectance
