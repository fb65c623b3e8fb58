#include "app/explorer/layout.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {
namespace {

constexpr float splitterWidth = 6.0F;
constexpr float narrowestPanels = 280.0F, widestPanels = 640.0F, narrowestPicture = 240.0F;
constexpr float lowestWorkbench = 140.0F, lowestPicture = 120.0F;

} // namespace

Area takeGuideColumn(Area& picture, float scale)
{
    const float width =
        std::min(std::clamp(0.4F * picture.width, 250.0F * scale, 350.0F * scale), 0.75F * picture.width);
    const Area column{picture.x, picture.y, std::floor(width), picture.height};
    picture.x += column.width;
    picture.width -= column.width;
    return column;
}

float allowedPanelWidth(float wanted, float windowWidth, float scale)
{
    const float most = std::min(widestPanels, windowWidth / scale - narrowestPicture - splitterWidth);
    return std::clamp(wanted, narrowestPanels, std::max(narrowestPanels, most));
}

float allowedWorkbenchHeight(float wanted, float room, float scale)
{
    const float most = room / scale - lowestPicture - splitterWidth;
    return std::clamp(wanted, lowestWorkbench, std::max(lowestWorkbench, most));
}

Layout layoutOf(float width, float height, Bars bars, Wishes wishes, float scale)
{
    const float top = std::round(bars.toolbar);
    const float low = std::round(bars.status);
    const float bar = std::round(splitterWidth * scale);
    const float side = std::min(std::round(allowedPanelWidth(wishes.panelWidth, width, scale) * scale), width);
    const float middle = std::max(0.0F, height - top - low);
    const float left = std::max(0.0F, width - side - bar);

    const float tabs = std::min(std::round(bars.tabs), middle);
    const float room = middle - tabs;
    const bool open = wishes.workbenchHeight > 0.0F;
    const float grip = open ? std::min(bar, room) : 0.0F;
    const float wanted = std::round(allowedWorkbenchHeight(wishes.workbenchHeight, room, scale) * scale);
    const float bench = open ? std::min(wanted, room - grip) : 0.0F;
    const float picture = room - grip - bench;
    return {
        .toolbar = {0.0F, 0.0F, width, top},
        .picture = {0.0F, top, left, picture},
        .splitter = {left, top, bar, middle},
        .panels = {width - side, top, side, middle},
        .status = {0.0F, top + middle, width, low},
        .tabs = {0.0F, top + picture, left, tabs},
        .grip = {0.0F, top + picture + tabs, left, grip},
        .workbench = {0.0F, top + picture + tabs + grip, left, bench},
    };
}

} // namespace reflectance::explorer
