// Where things stand in the window: toolbar above, picture left, panels right, status line below.
#pragma once

namespace reflectance::explorer {

/// In the window's own coordinates (points), (0, 0) its upper left corner.
struct Area {
    float x = 0.0F, y = 0.0F, width = 0.0F, height = 0.0F;

    [[nodiscard]] float right() const { return x + width; }
    [[nodiscard]] float bottom() const { return y + height; }
};

struct Layout {
    Area toolbar, picture, splitter, panels, status;
};

/// Heights of the two bars, in points.
struct Bars {
    float toolbar = 0.0F, status = 0.0F;
};

/// `panelWidth` is at scale 1. Where the window has room for both, the panels keep at least 280 and the picture at
/// least 240 points times the scale.
[[nodiscard]] Layout layoutOf(float width, float height, Bars bars, float panelWidth, float scale);

/// The width within which the splitter moves the panels, at scale 1.
[[nodiscard]] float allowedPanelWidth(float wanted, float windowWidth, float scale);

} // namespace reflectance::explorer
