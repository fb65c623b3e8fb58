#include "app/explorer/layout.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {
namespace {

constexpr float splitterWidth = 6.0F;
constexpr float narrowestPanels = 280.0F, widestPanels = 640.0F, narrowestPicture = 240.0F;

} // namespace

float allowedPanelWidth(float wanted, float windowWidth, float scale)
{
    const float most = std::min(widestPanels, windowWidth / scale - narrowestPicture - splitterWidth);
    return std::clamp(wanted, narrowestPanels, std::max(narrowestPanels, most));
}

Layout layoutOf(float width, float height, Bars bars, float panelWidth, float scale)
{
    const float top = std::round(bars.toolbar);
    const float low = std::round(bars.status);
    const float bar = std::round(splitterWidth * scale);
    const float side = std::min(std::round(allowedPanelWidth(panelWidth, width, scale) * scale), width);
    const float middle = std::max(0.0F, height - top - low);
    const float left = std::max(0.0F, width - side - bar);
    return {
        .toolbar = {0.0F, 0.0F, width, top},
        .picture = {0.0F, top, left, middle},
        .splitter = {left, top, bar, middle},
        .panels = {width - side, top, side, middle},
        .status = {0.0F, top + middle, width, low},
    };
}

} // namespace reflectance::explorer
