#include "app/explorer/guide.h"

#include "app/explorer/state.h"

#include <algorithm>
#include <limits>

namespace reflectance::explorer {

void showTourStep(ExplorerState& state, int number)
{
    number = std::clamp(number, 1, tourLength());
    Result<TourStep> step = tourStep(number);
    if (!step) {
        state.message = Message{step.error().sentence(), true};
        return;
    }
    putAside(state, "Tour: " + step->title, {});
    state.guide = Guide{number, *std::move(step), 0, false, {}};
    state.scene = state.guide.step.scene;
    state.compare.on = state.scene.other.has_value();
    state.compare.mode = CompareMode::SideBySide;
    state.selectedLight = state.scene.lights.empty() ? -1 : 0;
    state.preferences.tourStep = number;
}

void revealAnswer(Guide& guide)
{
    guide.revealed = true;
    guide.values.clear();
    for (const Claim& claim : guide.step.claims) {
        const Result<double> value = measured(claim, guide.step);
        guide.values.push_back(value ? *value : std::numeric_limits<double>::quiet_NaN());
    }
}

} // namespace reflectance::explorer
