#include "app/explorer/probe_view.h"

#include "app/explorer/probe_overlay.h"
#include "app/explorer/ui/probe_card.h"

#include <imgui.h>

namespace reflectance::explorer {
namespace {

void drawPane(const Session& session, const Area& pane, bool isB)
{
    PictureView view = session.viewport.view;
    view.x = pane.x;
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    canvas.PushClipRect({pane.x, pane.y}, {pane.right(), pane.bottom()}, true);
    drawProbeMarks(canvas, session.state, view, isB);
    canvas.PopClipRect();
}

} // namespace

void drawProbes(Session& session, const Area& area)
{
    pollProbes(session);
    ExplorerState& state = session.state;
    const CompareView& compare = state.compare;
    const Panes panes = panesOf(compare, area, session.window.scale());
    drawPane(session, panes.a, compare.on && compare.mode == CompareMode::Flip && compare.handOnB);
    if (compare.on && compare.mode == CompareMode::SideBySide)
        drawPane(session, panes.b, true);
    if (!session.viewport.dragging())
        drawProbeCard(state, {panes.a.x, panes.a.y}, {panes.a.right(), panes.a.bottom()});
}

} // namespace reflectance::explorer
