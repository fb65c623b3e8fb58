#include "app/explorer/keys.h"

#include <algorithm>

namespace reflectance::explorer {
namespace {

using Kind = Request::Kind;

void request(ExplorerState& state, Kind kind, const std::string& path = {})
{
    state.requests.push_back({kind, path});
}

/// F2 .. F11 stand for the workbench's first ten pages; -1 for every other key.
int pageOfKey(const std::string& key)
{
    if (key == "F10" || key == "F11")
        return key == "F10" ? 8 : 9;
    return key.size() == 2 && key[0] == 'F' && key[1] >= '2' && key[1] <= '9' ? key[1] - '2' : -1;
}

void nextModel(ExplorerState& state, int step)
{
    const std::vector<Model>& models = catalogue();
    const auto count = static_cast<int>(models.size());
    Surface& surface = surfaceInHand(state.compare, state.scene);
    const auto here =
        std::find_if(models.begin(), models.end(), [&](const Model& model) { return model.id() == surface.model; });
    const int next = (static_cast<int>(here - models.begin()) + step + count) % count;
    surface.model = models[static_cast<std::size_t>(next)].id();
}

void showClayOrPutItAway(ExplorerState& state)
{
    toggleClay(state.compare, state.scene);
    state.selectedLight = state.scene.lights.empty() ? -1 : 0;
    state.soloLight = -1;
    if (state.compare.beforeClay)
        request(state, Kind::Frame); // half the window is narrower
}

void selectLight(ExplorerState& state, int index)
{
    if (index < static_cast<int>(state.scene.lights.size()))
        state.selectedLight = index;
}

/// On or off; with Shift the next arithmetic.
void pressLens(ExplorerState& state, bool shift)
{
    if (!shift)
        state.lens = state.lens ? std::nullopt : std::optional(LensKind::Float);
    else if (state.lens)
        state.lens = lensKinds[(static_cast<std::size_t>(*state.lens) + 1) % std::size(lensKinds)];
}

/// Pixels of a step of the arrow keys, and what a step multiplies n by.
constexpr double wideStep = 8.0, fineStep = 1.0;
constexpr double exponentStep = 1.189207115002721; // 2^(1/4)

bool isArrow(const std::string& key)
{
    return key == "Left" || key == "Right" || key == "Up" || key == "Down";
}

/// The tool Grab by keyboard: arrows move the highlight, with Control by one pixel; Shift with Up and Down makes it narrower
/// and wider.
void pressArrow(const KeyPress& key, ExplorerState& state)
{
    const double dx = key.key == "Left" ? -1.0 : key.key == "Right" ? 1.0 : 0.0;
    const double dy = key.key == "Up" ? -1.0 : key.key == "Down" ? 1.0 : 0.0;
    if (key.shift) {
        if (dy != 0.0)
            narrowSpot(state.compare, state.scene, dy < 0.0 ? exponentStep : 1.0 / exponentStep);
        return;
    }
    const double step = key.control ? fineStep : wideStep;
    if (const auto moved = nudgeSpot(state.grab, state.compare, state.scene, state.selectedLight, step * dx, step * dy);
        !moved)
        state.message = Message{moved.error().sentence(), true};
}

void toggleTour(ExplorerState& state)
{
    if (state.guide.number > 0)
        request(state, Kind::LeaveCase);
    else
        request(state, Kind::ShowTour);
}

void requestForOffered(ExplorerState& state, Kind kind)
{
    if (const EarlierSession* offered = offeredSession(state))
        state.requests.push_back({kind, offered->file});
}

/// Closes what lies on top: an overlay, then loading, then a message, then a term seen alone, then a probe that is not pinned,
/// then a hazard's case, then the offer of an earlier session.
void escape(ExplorerState& state)
{
    if (state.showHelp || state.showFileBrowser)
        state.showHelp = state.showFileBrowser = false;
    else if (state.loading)
        request(state, Kind::CancelLoading);
    else if (state.message)
        state.message.reset();
    else if (!state.probe.term.empty())
        state.probe.term.clear();
    else if (state.probe.loose)
        state.probe.probe(std::nullopt);
    else if (leaveCase(state))
        return;
    else
        requestForOffered(state, Kind::Dismiss);
}

void pressWithControl(const KeyPress& pressed, ExplorerState& state)
{
    const std::string& key = pressed.key;
    if (key == "o")
        request(state, Kind::OpenDialog);
    else if (key == "s")
        request(state, Kind::SaveScene);
    else if (key == "r")
        requestForOffered(state, Kind::OpenFile);
    else if (key == "y" || (key == "z" && pressed.shift))
        request(state, Kind::Redo);
    else if (key == "z")
        request(state, Kind::Undo);
    else if (key == "q")
        request(state, Kind::Quit);
    else if (key == "F12")
        request(state, Kind::SaveWindow);
}

void pressAlone(const KeyPress& key, ExplorerState& state)
{
    if (key.key == "f")
        request(state, Kind::Frame);
    else if (key.key == "r")
        request(state, Kind::ResetView);
    else if (key.key == "t")
        state.turntable = !state.turntable;
    else if (key.key == "h")
        state.preferences.showLightHandles = !state.preferences.showLightHandles;
    else if (key.key == "l")
        pressLens(state, key.shift);
    else if (key.key == "c")
        toggleCompare(state.compare, state.scene);
    else if (key.key == "x" && state.compare.on)
        state.compare.handOnB = !state.compare.handOnB;
    else if (key.key == "b")
        showClayOrPutItAway(state);
    else if (key.key == "s")
        state.grab.on = !state.grab.on;
    else if (key.key == "p")
        state.probe.asked = true;
    else if (key.key == "m")
        nextModel(state, key.shift ? -1 : 1);
    else if (key.key.size() == 1 && key.key[0] >= '1' && key.key[0] <= '9')
        selectLight(state, key.key[0] - '1');
    else if (key.key == "g")
        toggleTour(state);
    else if (state.guide.number > 0 && (key.key == "PageDown" || key.key == "PageUp"))
        request(state, Kind::ShowTour, std::to_string(state.guide.number + (key.key == "PageDown" ? 1 : -1)));
    else if (key.key == "F1")
        state.showHelp = !state.showHelp;
    else if (key.key == "F12")
        request(state, Kind::SaveView);
    else if (const int page = pageOfKey(key.key); page >= 0)
        request(state, Kind::TogglePage, std::to_string(page));
    else if (key.key == "Esc")
        escape(state);
}

} // namespace

void press(const KeyPress& key, ExplorerState& state)
{
    const bool isCharacter = key.key.size() == 1;
    if (state.showFileBrowser && isCharacter)
        return; // the dialog has the keyboard
    if (isArrow(key.key)) {
        if (state.grab.on)
            pressArrow(key, state);
    } else if (key.control)
        pressWithControl(key, state);
    else
        pressAlone(key, state);
}

} // namespace reflectance::explorer
