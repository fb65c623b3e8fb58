#include "app/explorer/exhibition.h"

#include "app/explorer/state.h"

#include <utility>

namespace reflectance::explorer {

void showCase(ExplorerState& state, const Finding& finding)
{
    Exhibit exhibit = exhibitOf(finding);
    if (!exhibit.scene) {
        state.message = Message{finding.id + ", " + finding.danger + ": " + exhibit.caption, false};
        return;
    }
    if (!state.putAside)
        state.putAside =
            PutAside{std::move(state.scene), state.selectedLight, state.soloLight, state.turntable, {}, {}};
    state.putAside->title = finding.id + "  " + finding.danger;
    state.putAside->caption = std::move(exhibit.caption);
    state.scene = *std::move(exhibit.scene);
    state.selectedLight = state.scene.lights.empty() ? -1 : 0;
    state.soloLight = -1;
    state.turntable = false;
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
    return true;
}

const Scene& usersScene(const ExplorerState& state)
{
    return state.putAside ? state.putAside->scene : state.scene;
}

} // namespace reflectance::explorer
