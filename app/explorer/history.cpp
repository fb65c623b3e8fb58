#include "app/explorer/history.h"

#include "app/explorer/state.h"
#include "core/geometry/mesh_bytes.h"

#include <algorithm>
#include <set>
#include <utility>

namespace reflectance::explorer {
namespace {

Moment momentOf(const ExplorerState& state)
{
    return {state.scene, state.compare.on, state.compare.mode, state.compare.beforeClay, state.putAside};
}

/// The tour as far as a step of it; a file that was read before is read again.
Guide guideAt(int number)
{
    Result<TourStep> step = tourStep(number);
    return step ? Guide{number, *std::move(step), 0, false, {}} : Guide();
}

/// Adds what the scene shares with other steps, each object once.
void addShared(const Scene& scene, std::set<const void*>& counted, std::size_t& bytes)
{
    if (scene.mesh && counted.insert(scene.mesh.get()).second)
        bytes += bytesOf(*scene.mesh);
    if (scene.environment.map && counted.insert(scene.environment.map.get()).second)
        bytes += sizeof(float) * (scene.environment.map->rgb.size() + scene.environment.map->coverage.size());
    std::vector<const Surface*> surfaces{&scene.surface};
    if (scene.other)
        surfaces.push_back(&*scene.other);
    for (const KeptSurface& variant : scene.variants)
        surfaces.push_back(&variant.surface);
    for (const Surface* surface : surfaces)
        if (surface->table && counted.insert(surface->table.get()).second)
            bytes += sizeof(double) * surface->table->table.values.size();
}

/// The arrow keys of the tool Grab have moved the selected light to where it is.
bool movedByKeys(const ExplorerState& state)
{
    const auto index = static_cast<std::size_t>(std::max(0, state.selectedLight));
    return index < state.scene.lights.size() && state.grab.spotLight == state.scene.lights[index];
}

/// One more step of a key that is held, or pressed again at once.
bool continuesKeys(const HistoryStep& last, const Moment& moment, const ExplorerState& state)
{
    return movedByKeys(state) && last.name.starts_with("Move ") && nameOfChange(last.after, moment) == last.name;
}

} // namespace

void History::watch(const ExplorerState& state, Hand hand, Time now)
{
    Moment moment = momentOf(state);
    if (steps_.empty()) {
        steps_.push_back({"Start", std::move(moment), state.selectedLight, state.guide.number});
        return;
    }
    const Moment& last = steps_[here_].after;
    if (moment == last || hand.busy || (hand.turning && onlyCameraDiffers(last, moment)) ||
        (hand.loading && onlySmoothingDiffers(last, moment)))
        return;
    const bool soon = lastZoom_ && now - *lastZoom_ < zoomPause && !canRedo();
    if (continuesZoom(moment, now) || (soon && continuesKeys(steps_[here_], moment, state))) {
        steps_[here_].after = std::move(moment);
        lastZoom_ = now;
        return;
    }
    push(state, std::move(moment), now);
}

bool History::continuesZoom(const Moment& moment, Time now) const
{
    const Moment& last = steps_[here_].after;
    return lastZoom_ && now - *lastZoom_ < zoomPause && !canRedo() && steps_[here_].name == "Zoom" &&
           onlyCameraDiffers(last, moment) && isZoom(last.scene.camera, moment.scene.camera);
}

void History::push(const ExplorerState& state, Moment moment, Time now)
{
    const Moment& last = steps_[here_].after;
    const bool zoomed = onlyCameraDiffers(last, moment) && isZoom(last.scene.camera, moment.scene.camera);
    const bool byKeys = movedByKeys(state) && nameOfChange(last, moment).starts_with("Move ");
    lastZoom_ = zoomed || byKeys ? std::optional(now) : std::nullopt;
    std::string name = nameOfChange(last, moment);
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(here_ + 1), steps_.end());
    steps_.push_back({std::move(name), std::move(moment), state.selectedLight, state.guide.number});
    while (steps_.size() > mostSteps + 1 || (steps_.size() > 2 && heldBytes() > mostBytes_))
        steps_.pop_front();
    here_ = steps_.size() - 1;
}

std::string History::undoName() const
{
    return canUndo() ? steps_[here_].name : std::string();
}

std::string History::redoName() const
{
    return canRedo() ? steps_[here_ + 1].name : std::string();
}

void History::undo(ExplorerState& state)
{
    watch(state, {}, {});
    if (canUndo())
        go(here_ - 1, state);
}

void History::redo(ExplorerState& state)
{
    watch(state, {}, {});
    if (canRedo())
        go(here_ + 1, state);
}

void History::go(std::size_t step, ExplorerState& state)
{
    watch(state, {}, {});
    if (step >= steps_.size())
        return;
    here_ = step;
    lastZoom_.reset();
    show(state);
}

void History::show(ExplorerState& state)
{
    const HistoryStep& step = steps_[here_];
    state.scene = step.after.scene;
    state.compare.on = step.after.comparing;
    state.compare.mode = step.after.mode;
    state.compare.handOnB = state.compare.handOnB && step.after.comparing;
    state.compare.beforeClay = step.after.beforeClay;
    state.putAside = step.after.putAside;
    state.selectedLight = std::min(step.selectedLight, static_cast<int>(state.scene.lights.size()) - 1);
    state.soloLight = -1;
    if (state.guide.number != step.tourStep)
        state.guide = guideAt(step.tourStep);
    state.turntable = false;       // it would move the camera away from where it was
    state.panels.matrices.clear(); // what a narrower mode hid belongs to another state
}

std::size_t History::heldBytes() const
{
    std::set<const void*> counted;
    std::size_t bytes = 0;
    for (const HistoryStep& step : steps_) {
        addShared(step.after.scene, counted, bytes);
        if (step.after.putAside)
            addShared(step.after.putAside->scene, counted, bytes);
    }
    return bytes;
}

} // namespace reflectance::explorer
