// The lights as handles over the picture: a glowing disc where each light is held.
#pragma once

#include "app/explorer/gestures.h"
#include "app/explorer/state.h"

struct ImDrawList;

namespace reflectance::explorer {

/// The picture on the screen: its upper left corner in points, its size in pixels.
struct PictureView {
    float x = 0.0F, y = 0.0F;
    ViewSize size;
    float pixelsPerPoint = 1.0F;
    float scale = 1.0F; ///< of the interface

    [[nodiscard]] Cursor cursorAt(float pointX, float pointY) const
    {
        return {static_cast<double>((pointX - x) * pixelsPerPoint), static_cast<double>((pointY - y) * pixelsPerPoint)};
    }
};

/// How far from a handle's centre, in pixels, the mouse takes it.
[[nodiscard]] double handleReach(const PictureView& view);

/// `hovered` and `held` are light indices, -1 for none.
void drawLightHandles(ImDrawList& canvas, const ExplorerState& state, const PictureView& view, int hovered, int held);

/// Name, direction or place, and intensity of a light, as a tooltip.
void showLightTooltip(const ExplorerState& state, int light);

} // namespace reflectance::explorer
