#include "app/explorer/measured_prices.h"

#include "core/image/compare.h"
#include "core/math/quantile.h"
#include "core/scene/requirements.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace reflectance::explorer {
namespace {

constexpr int repetitions = 3;

struct Shaded {
    Image image;
    double milliseconds = 0.0, generalMilliseconds = 0.0;
};

/// The median of a few; one alone where it took long, for then it is not the clock that is coarse. Where the general path is
/// asked for too, the two take turns.
Shaded shadedOnCpu(const ViewSamples& samples, const Scene& scene, Precision precision, Progress& progress,
                   bool alsoGeneral = false)
{
    using namespace std::chrono;
    Shaded shaded;
    std::vector<double> times, general;
    const auto timed = [&](const Arithmetic& arithmetic) {
        const auto start = steady_clock::now();
        shaded.image = shadeSamples(samples, scene, arithmetic, &progress);
        return duration<double, std::milli>(steady_clock::now() - start).count();
    };
    while (times.size() < repetitions && !progress.cancel) {
        if (alsoGeneral)
            general.push_back(timed({precision, LobeForm::Conditioned, false}));
        times.push_back(timed(precision));
        if (times.back() > 100.0)
            break;
    }
    shaded.milliseconds = medianOf(std::move(times));
    shaded.generalMilliseconds = medianOf(std::move(general));
    return shaded;
}

double coveredShare(const ViewSamples& samples)
{
    const std::vector<std::uint32_t>& first = samples.firstOfPixel;
    std::size_t covered = 0;
    for (std::size_t pixel = 0; pixel + 1 < first.size(); ++pixel)
        covered += first[pixel + 1] > first[pixel] ? 1U : 0U;
    return static_cast<double>(covered) / static_cast<double>(std::max<std::size_t>(1, first.size() - 1));
}

PriceTag tagOf(std::string name, const Shaded& shaded, const Image& truth, double covered)
{
    PriceTag tag;
    tag.name = std::move(name);
    tag.milliseconds = shaded.milliseconds;
    tag.generalMilliseconds = shaded.generalMilliseconds;
    const Result<Comparison> difference = compared(truth, shaded.image);
    if (!difference || difference->identical)
        return tag;
    tag.maxError = difference->maxAbs;
    tag.rmse = covered > 0.0 ? difference->rmse / std::sqrt(covered) : 0.0;
    tag.worstX = difference->x;
    tag.worstY = difference->y;
    return tag;
}

} // namespace

std::optional<Prices> measuredPrices(const Scene& scene, const DrawnByGl& drawn, Progress& progress)
{
    const double covered = coveredShare(drawn.samples);
    const Shaded exact = shadedOnCpu(drawn.samples, scene, Precision::Double, progress);
    const Shaded single = shadedOnCpu(drawn.samples, scene, Precision::Float, progress);
    const Shaded lanes =
        shadedOnCpu(drawn.samples, scene, Precision::Simd, progress, !requiredSurface(scene).leftOut.empty());
    if (progress.cancel)
        return std::nullopt;
    Prices prices;
    prices.tags = {tagOf("double", exact, exact.image, covered), tagOf("float", single, exact.image, covered),
                   tagOf("simd", lanes, exact.image, covered),
                   tagOf("gl", {drawn.linear, drawn.milliseconds}, exact.image, covered)};
    prices.counts = develop(drawn.linear, scene.sensor).counts;
    return prices;
}

} // namespace reflectance::explorer
