#include "app/explorer/trade_study.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

Wanted TradeStudy::wanted() const
{
    return byTime ? Wanted{{}, milliseconds} : Wanted{tolerance, {}};
}

std::optional<std::size_t> TradeStudy::shown() const
{
    if (!trade)
        return std::nullopt;
    if (selected && *selected < trade->candidates.size())
        return selected;
    return chosen(*trade, wanted());
}

RenderSettings measuredSettings(const RenderSettings& view)
{
    constexpr double mostPixels = 350000.0;
    const double pixels = static_cast<double>(Image::pixelCount(view.width, view.height));
    const double scale = std::min(1.0, std::sqrt(mostPixels / std::max(1.0, pixels)));
    const auto scaled = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * scale))); };
    return {scaled(view.width), scaled(view.height), view.samplesPerAxis};
}

bool looksTheSame(const Scene& a, const Scene& b)
{
    return a.mesh == b.mesh && a.camera == b.camera && a.lights == b.lights && a.environment == b.environment &&
           a.background == b.background && a.surface == b.surface && a.sensor == b.sensor;
}

} // namespace reflectance::explorer
