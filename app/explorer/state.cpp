#include "app/explorer/state.h"

#include "core/sensor/fields.h"

#include <algorithm>

namespace reflectance::explorer {

const EarlierSession* offeredSession(const ExplorerState& state)
{
    const auto& sessions = state.earlierSessions;
    const auto found = std::find_if(sessions.begin(), sessions.end(), [](const auto& one) { return !one.dismissed; });
    return found == sessions.end() ? nullptr : &*found;
}

Scene shownScene(const ExplorerState& state)
{
    Scene scene = state.scene;
    scene.surface.showHoles = true;
    if (scene.other)
        scene.other->showHoles = true;
    if (!state.soloPart.empty())
        scene.sensor = onlyPart(scene.sensor, state.soloPart);
    if (state.soloLight < 0 || state.soloLight >= static_cast<int>(scene.lights.size()))
        return scene;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        scene.lights[i].on = static_cast<int>(i) == state.soloLight;
    return scene;
}

} // namespace reflectance::explorer
