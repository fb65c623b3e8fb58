#include "core/image/waterfall.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

struct Sums {
    double squares = 0.0, alongAll = 0.0, maxAbs = 0.0;

    void add(double change, double whole)
    {
        squares += change * change;
        alongAll += change * whole;
        maxAbs = std::max(maxAbs, std::fabs(change));
    }
};

bool isFiniteIn(std::span<const WaterfallPicture> pictures, std::size_t channel)
{
    return std::all_of(pictures.begin(), pictures.end(),
                       [channel](const auto& p) { return std::isfinite(p.image.rgb[channel]); });
}

} // namespace

Result<Waterfall> waterfallOf(std::span<const WaterfallPicture> pictures)
{
    if (pictures.size() < 2)
        return Error{"a waterfall needs the truth and at least one picture after it"};
    const Image& truth = pictures.front().image;
    for (const WaterfallPicture& picture : pictures)
        if (picture.image.width != truth.width || picture.image.height != truth.height)
            return Error{"the pictures of a waterfall have different sizes; render them in one size"};
    std::vector<Sums> sums(pictures.size() - 1);
    Sums all;
    Waterfall waterfall;
    for (std::size_t i = 0; i < truth.rgb.size(); ++i) {
        if (!isFiniteIn(pictures, i)) {
            ++waterfall.leftOut;
            continue;
        }
        const auto at = [&](std::size_t p) { return double{pictures[p].image.rgb[i]}; };
        const double whole = at(sums.size()) - at(0);
        all.add(whole, whole);
        for (std::size_t s = 0; s < sums.size(); ++s)
            sums[s].add(at(s + 1) - at(s), whole);
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, truth.rgb.size() - waterfall.leftOut));
    for (std::size_t s = 0; s < sums.size(); ++s)
        waterfall.steps.push_back({pictures[s + 1].step, std::sqrt(sums[s].squares / count), sums[s].maxAbs,
                                   all.squares > 0.0 ? sums[s].alongAll / all.squares : 0.0});
    waterfall.rmse = std::sqrt(all.squares / count);
    waterfall.maxAbs = all.maxAbs;
    return waterfall;
}

} // namespace reflectance
