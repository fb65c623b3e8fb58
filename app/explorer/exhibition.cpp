#include "app/explorer/exhibition.h"

#include "app/explorer/state.h"

#include <utility>

namespace reflectance::explorer {

void putAside(ExplorerState& state, std::string title, std::string caption)
{
    if (!state.putAside)
        state.putAside = PutAside{state.scene,
                                  state.selectedLight,
                                  state.soloLight,
                                  state.turntable,
                                  state.compare.on,
                                  state.compare.mode,
                                  {},
                                  {}};
    state.putAside->title = std::move(title);
    state.putAside->caption = std::move(caption);
    state.soloLight = -1;
    state.probe.term.clear();
    state.turntable = false;
    state.compare.on = false;
    state.compare.handOnB = false;
    state.compare.beforeClay.reset();
}

void showCase(ExplorerState& state, const Finding& finding)
{
    Exhibit exhibit = exhibitOf(finding);
    if (!exhibit.scene) {
        state.message = Message{finding.id + ", " + finding.danger + ": " + exhibit.caption, false};
        return;
    }
    putAside(state, finding.id + "  " + finding.danger, std::move(exhibit.caption));
    state.guide.number = 0;
    state.scene = *std::move(exhibit.scene);
    state.selectedLight = state.scene.lights.empty() ? -1 : 0;
    state.message.reset();
}

bool leaveCase(ExplorerState& state)
{
    std::optional<PutAside> users = std::exchange(state.putAside, std::nullopt);
    if (!users)
        return false;
    state.scene = std::move(users->scene);
    state.selectedLight = users->selectedLight;
    state.soloLight = users->soloLight;
    state.turntable = users->turntable;
    state.compare.on = users->comparing;
    state.compare.mode = users->mode;
    state.compare.handOnB = false;
    state.compare.beforeClay.reset();
    state.guide.number = 0;
    return true;
}

const Scene& usersScene(const ExplorerState& state)
{
    return state.putAside ? state.putAside->scene : state.scene;
}

} // namespace reflectance::explorer
