#include "app/explorer/probes.h"

#include "app/explorer/session.h"
#include "app/explorer/viewed_scene.h"
#include "core/scene/same_scene.h"

#include <imgui.h>

#include <utility>

namespace reflectance::explorer {
namespace {

bool hasPlaces(const ExplorerState& state)
{
    return state.probe.loose || !state.scene.pins.empty();
}

/// True where what was found is of another scene, picture or wish.
bool isStale(const Probes& probes, const ExplorerState& state, const Scene& viewed, ViewSize size)
{
    const ProbeStudy& study = state.probe;
    return probes.changes != study.changes || probes.size != size || probes.comparing != state.compare.on ||
           probes.lobe != study.lobe || probes.light != study.light || !probes.viewed || !(*probes.viewed == viewed);
}

void readPixels(Session& session, FoundProbe& found)
{
    found.pixelA.reset();
    found.pixelB.reset();
    const Rested* rested = session.trust.rested.get();
    if (!rested)
        return;
    found.pixelA = pixelOf(rested->drawn.samples, rested->drawn.linear, rested->scene, found.a.point);
    const Image& b = session.probes.b;
    if (found.b && b.width == rested->drawn.linear.width && b.height == rested->drawn.linear.height)
        found.pixelB = pixelOf(rested->drawn.samples, b, variantB(rested->scene), found.b->point);
}

void readAllPixels(Session& session)
{
    Probes& probes = session.probes;
    ProbeStudy& study = session.state.probe;
    if (probes.rested != session.trust.rested) {
        probes.rested = session.trust.rested;
        const std::optional<Surface>& other = session.state.scene.other;
        const bool byGl = session.second.renderer && other && other->rungs.empty();
        probes.b = probes.rested && session.state.compare.on && byGl ? session.second.renderer->readLinear() : Image();
    }
    for (std::optional<FoundProbe>& found : study.foundPins)
        if (found)
            readPixels(session, *found);
    if (study.foundLoose)
        readPixels(session, *study.foundLoose);
}

} // namespace

void serveProbeKey(Session& session)
{
    ExplorerState& state = session.state;
    if (!std::exchange(state.probe.asked, false))
        return;
    const Viewport& viewport = session.viewport;
    const ViewSize size = viewport.view.size;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Cursor middle{0.5 * size.width, 0.5 * size.height};
    const Cursor cursor = viewport.hovered ? viewport.view.cursorAt(mouse.x, mouse.y) : middle;
    probeUnder(state, cursor, size);
    session.viewport.done.emplace_back(RecordedProbe{cursor, size});
    state.preferences.workbenchPage = "probe";
    state.probe.detail = ProbeDetail::Point;
}

void pollProbes(Session& session)
{
    ExplorerState& state = session.state;
    Probes& probes = session.probes;
    if (!hasPlaces(state)) {
        if (probes.changes != state.probe.changes || !state.probe.foundPins.empty()) {
            examine(state, state.scene, session.viewport.view.size);
            probes.changes = state.probe.changes;
        }
        return;
    }
    Scene viewed = viewedScene(state);
    const ViewSize size = session.viewport.view.size;
    const bool stale = isStale(probes, state, viewed, size);
    if (stale) {
        examine(state, viewed, size);
        probes.viewed = std::move(viewed);
        probes.size = size;
        probes.comparing = state.compare.on;
        probes.lobe = state.probe.lobe;
        probes.light = state.probe.light;
        probes.changes = state.probe.changes;
    }
    if (stale || probes.rested != session.trust.rested)
        readAllPixels(session);
}

} // namespace reflectance::explorer
