#include "core/chart/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace reflectance {
namespace {

/// Between colours that stand at even distances over 0 .. 1.
ChartColor between(std::span<const ChartColor> colors, double share)
{
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), colors.size() - 2);
    const double t = place - static_cast<double>(below);
    ChartColor mixed = 0;
    for (const int shift : {16, 8, 0}) {
        const auto channel = [shift](ChartColor color) { return static_cast<double>((color >> shift) & 0xFFU); };
        const double value = (1.0 - t) * channel(colors[below]) + t * channel(colors[below + 1]);
        mixed |= static_cast<ChartColor>(std::lround(value)) << shift;
    }
    return mixed;
}

} // namespace

ChartColor sequentialColor(double share)
{
    constexpr std::array<ChartColor, 9> viridis = {0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C,
                                                   0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725};
    return between(viridis, share);
}

ChartColor divergingColor(double share)
{
    constexpr std::array<ChartColor, 5> course = {0x56B4E9, 0x0072B2, 0x4A4A4A, 0xD55E00, 0xFFB000};
    return between(course, 0.5 * (share + 1.0));
}

} // namespace reflectance
