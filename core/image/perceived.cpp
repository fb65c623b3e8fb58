#include "core/image/perceived.h"

#include "core/base/check.h"
#include "core/math/quantile.h"

#include <algorithm>
#include <future>
#include <numeric>

namespace reflectance {

PerceivedReference::PerceivedReference(const Image& reference, Over over) : flip_(reference)
{
    for (std::size_t pixel = 0; pixel < reference.pixels(); ++pixel) {
        colours_.push_back(labOfDisplayed(&reference.rgb[3 * pixel]));
        const bool covered = pixel < reference.coverage.size() && reference.coverage[pixel] > 0.0F;
        if (over == Over::AllPixels || covered)
            pixels_.push_back(pixel);
    }
}

double PerceivedReference::deltaEAt(std::size_t pixel, const Image& test) const
{
    return deltaE2000(colours_[pixel], labOfDisplayed(&test.rgb[3 * pixel]));
}

PerceivedDifference PerceivedReference::to(const Image& test) const
{
    CHECK_EQ(test.pixels(), colours_.size());
    std::future<double> flip =
        std::async(std::launch::async, [&] { return flip_.meanOf(test); }); // as long as the rest
    std::vector<double> errors;
    errors.reserve(pixels_.size());
    for (const std::size_t pixel : pixels_)
        errors.push_back(deltaEAt(pixel, test));
    PerceivedDifference result;
    result.flipMean = flip.get();
    if (errors.empty())
        return result;
    result.deltaEMean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    result.deltaEMax = *std::max_element(errors.begin(), errors.end());
    result.deltaEP95 = leastCovering(std::move(errors), 0.95);
    return result;
}

} // namespace reflectance
