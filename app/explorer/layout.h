// Where things stand in the window: toolbar above, picture left with the workbench below it, panels right, status line at
// the foot.
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
    Area tabs;      ///< of the workbench: a strip below the picture
    Area grip;      ///< moves the workbench's upper edge; no height while it is closed
    Area workbench; ///< no height while it is closed
};

/// Heights of the bars, in points.
struct Bars {
    float toolbar = 0.0F, status = 0.0F, tabs = 0.0F;
};

/// What the user has pulled the two inner edges to, at scale 1.
struct Wishes {
    float panelWidth = 360.0F;
    float workbenchHeight = 0.0F; ///< 0: closed
};

/// Where the window has room for both, the panels keep at least 280 and the picture at least 240 x 120 points times the
/// scale.
[[nodiscard]] Layout layoutOf(float width, float height, Bars bars, Wishes wishes, float scale);

/// Takes a column for the tour's card off the picture's left: two fifths of it, 250 .. 350 points times the scale. Returns
/// the column.
[[nodiscard]] Area takeGuideColumn(Area& picture, float scale);

/// The width within which the splitter moves the panels, at scale 1.
[[nodiscard]] float allowedPanelWidth(float wanted, float windowWidth, float scale);

/// The height within which the grip moves the workbench, at scale 1; `room` is what picture and workbench share.
[[nodiscard]] float allowedWorkbenchHeight(float wanted, float room, float scale);

} // namespace reflectance::explorer
