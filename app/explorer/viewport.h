// The picture and the hand in it: renders the scene at the window's resolution and turns strokes into camera and light.
#pragma once

#include "app/explorer/layout.h"
#include "app/explorer/light_handles.h"
#include "app/explorer/recording.h"
#include "app/explorer/second_view.h"
#include "app/explorer/stand_in.h"
#include "core/render/gl/gl_renderer.h"

#include <chrono>

namespace reflectance::explorer {

using Clock = std::chrono::steady_clock;

struct Viewport {
    PictureView view; ///< side by side: of the half that the mouse was on
    Stroke stroke;
    RecordedStroke pressed;                 ///< how it began
    std::vector<RecordedEvent> done;        ///< strokes and turns of the wheel since the tape last took them
    MouseButton button = MouseButton::Left; ///< that the stroke began with
    bool strayed = false;                   ///< the stroke has left its start: it is no click
    int hoveredLight = -1;
    bool hovered = false; ///< the mouse is on the picture and on nothing that lies over it

    Camera shownCamera;              ///< of the last picture
    Clock::time_point cameraMoved{}; ///< when it last changed
    double fullMilliseconds = 0.0;   ///< of the last picture with all its samples
    RenderSettings settings;         ///< of the last picture
    bool cameraMoves = false;        ///< or moved a moment ago
    std::uint64_t pictures = 0;      ///< how many different ones were drawn
    bool refinementOwed = false;     ///< the last picture had fewer samples than wanted
    unsigned overlay = 0;            ///< a texture over the picture, row 0 the highest; 0 for none

    [[nodiscard]] bool dragging() const { return stroke.kind != Stroke::Kind::None; }
};

/// One sample per pixel is shown while the camera moves, and this long after: the longer all samples take, the surer
/// it must be that the hand rests, for it has to wait if it does not.
[[nodiscard]] Clock::duration restBeforeRefining(const Viewport& viewport);

/// Draws the picture, the handles and what the hand does, into an ImGui window over `area`.
void drawViewport(ExplorerState& state, Viewport& viewport, GlRenderer& renderer, SecondView& second, StandIn& standIn,
                  const Area& area, float pixelsPerPoint, float scale);

} // namespace reflectance::explorer
