#include "app/explorer/trust_view.h"

#include "app/explorer/ui/case_banner.h"
#include "app/explorer/ui/compare_overlay.h"
#include "app/explorer/ui/gl_badge.h"
#include "app/explorer/ui/lens_legend.h"
#include "app/explorer/ui/probe_card.h"
#include "app/explorer/ui/stops_legend.h"

#include <imgui.h>

#include <cmath>

namespace reflectance::explorer {
namespace {

/// The middle of a pixel of the picture, on the screen.
ImVec2 onScreen(const PictureView& view, int x, int y)
{
    return {view.x + (static_cast<float>(x) + 0.5F) / view.pixelsPerPoint,
            view.y + (static_cast<float>(y) + 0.5F) / view.pixelsPerPoint};
}

void showReading(Session& session)
{
    const Viewport& viewport = session.viewport;
    if (!viewport.hovered || viewport.dragging() || viewport.hoveredLight >= 0)
        return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Cursor cursor = viewport.view.cursorAt(mouse.x, mouse.y);
    if (const LensReading* reading =
            readPixel(session, static_cast<int>(std::floor(cursor.x)), static_cast<int>(std::floor(cursor.y))))
        showLensReading(*session.state.lens, *reading);
}

/// Beside the bar of a comparison the badge has no room in a narrow picture; it stands below it then.
float heightOfBarAbove(const ExplorerState& state, const Area& area, float margin)
{
    const float beside = (area.width - compareBarWidth(area.width)) / 2.0F;
    return state.compare.on && beside < glBadgeWidth(state) + margin ? compareBarHeight() : 0.0F;
}

} // namespace

void drawTrust(Session& session, const Area& area)
{
    ExplorerState& state = session.state;
    const float margin = 12.0F * session.window.scale();
    if (state.lens)
        showReading(session);
    if (worstPixelIsMarked(state)) {
        const GlPixel& worst = state.glCheck->worst;
        drawWorstPixel(state, onScreen(session.viewport.view, worst.x, worst.y), {area.x, area.y},
                       {area.right(), area.bottom()});
    }
    const float top = area.y + margin + heightOfBarAbove(state, area, margin);
    drawGlBadge(state, {area.x + margin, top});
    drawCaseBanner(state, {area.x + margin, top + 32.0F * session.window.scale()},
                   {area.width - 2.0F * margin, area.height});
    // Under the badge; a hazard's case has its own banner there.
    const float scale = session.window.scale();
    drawTermBanner(state, {area.x + margin, state.putAside ? area.bottom() - 84.0F * scale : top + 32.0F * scale},
                   area.width - 2.0F * margin);
    if (state.scene.sensor.view.kind == SensorViewKind::FalseColor)
        drawStopsLegend({area.x + margin, area.bottom() - margin});
    if (state.lens)
        drawLensLegend(state, {area.right() - margin, area.bottom() - margin});
}

} // namespace reflectance::explorer
