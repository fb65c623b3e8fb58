#include "app/explorer/recording.h"

#include "app/explorer/comparison.h"
#include "app/explorer/grab_tool.h"
#include "app/explorer/viewed_scene.h"
#include "core/scene/scene_json.h"

#include <algorithm>

namespace reflectance::explorer {
namespace {

using Json = ObjectReader::Json;

constexpr NamedValue<CompareMode> modeNames[] = {{"side", CompareMode::SideBySide},
                                                 {"wipe", CompareMode::Wipe},
                                                 {"flip", CompareMode::Flip},
                                                 {"difference", CompareMode::Difference}};

Json jsonOf(const ExplorerState& state)
{
    return {{"scene", sceneJson(state.scene, {{}, {}, true})},
            {"comparing", state.compare.on},
            {"hand_on_b", state.compare.handOnB},
            {"mode", modeNames[static_cast<std::size_t>(state.compare.mode)].name},
            {"selected", state.selectedLight}};
}

/// The mesh is not read again where it is the same: a scan may have millions of triangles.
void readDocument(ObjectReader object, ExplorerState& state)
{
    Scene scene = defaultScene();
    object.readObject("scene", [&](ObjectReader part) { readScene(part, scene, {}); });
    if (scene.meshFile == state.scene.meshFile && scene.recomputeNormals == state.scene.recomputeNormals &&
        state.scene.mesh)
        scene.mesh = state.scene.mesh;
    state.scene = std::move(scene);
    object.read("comparing", state.compare.on);
    object.read("hand_on_b", state.compare.handOnB);
    object.readNamed("mode", modeNames, state.compare.mode);
    object.read("selected", state.selectedLight, -1, 1000000);
    object.finish();
}

Result<void> setDocument(const Json& json, ExplorerState& state)
{
    std::optional<std::string> problem;
    ExplorerState changed = state;
    readDocument(ObjectReader(json, "recording", problem), changed);
    if (problem)
        return Error{*problem};
    state = std::move(changed);
    return {};
}

Result<void> edit(const RecordedEdit& edit, ExplorerState& state)
{
    try {
        return setDocument(jsonOf(state).patch(Json::parse(edit.patch)), state);
    } catch (const Json::exception&) {
        return Error{"an edit of the recording does not fit what was done before it; it was cut or changed by hand"};
    }
}

/// What keys ask for and what needs neither window nor disk; the rest is in the edits that follow.
void serveHere(ExplorerState& state)
{
    using Kind = Request::Kind;
    for (const Request& request : std::exchange(state.requests, {})) {
        if (request.kind == Kind::Undo)
            state.history.undo(state);
        else if (request.kind == Kind::Redo)
            state.history.redo(state);
        else if (request.kind == Kind::LeaveCase)
            leaveCase(state);
        else if (request.kind == Kind::ShowTour)
            showTourStep(state, request.path.empty() ? state.preferences.tourStep : std::stoi(request.path));
    }
}

void stroke(const RecordedStroke& recorded, ExplorerState& state)
{
    Scene& scene = state.scene;
    if (recorded.grasp) {
        const Stroke grab = grabStroke(*recorded.grasp, recorded.from, recorded.size, state.compare, scene);
        // Where it could not go, it did not go then either.
        if (grab.light >= 0 && follow(grab, recorded.size, recorded.to, state.compare, scene))
            state.selectedLight = grab.light;
        return;
    }
    const auto known = [&](int light) { return light < static_cast<int>(scene.lights.size()) ? light : -1; };
    const Stroke stroke = strokeFrom(recorded.button, recorded.modifiers, recorded.from, known(recorded.handle),
                                     known(recorded.selected), scene.lights, scene.camera, recorded.size);
    if (stroke.movesCamera())
        scene.camera = cameraOf(stroke, recorded.size, recorded.to);
    else if (stroke.light >= 0)
        scene.lights[static_cast<std::size_t>(stroke.light)] = lightOf(stroke, recorded.size, recorded.to);
    if (stroke.light >= 0)
        state.selectedLight = stroke.light;
}

} // namespace

std::string documentOf(const ExplorerState& state)
{
    return jsonText(jsonOf(state));
}

Result<void> replay(const RecordedEvent& event, ExplorerState& state)
{
    Result<void> done;
    if (const auto* key = std::get_if<KeyPress>(&event)) {
        press(*key, state);
        state.probe.asked = false; // where it fell is an event of its own
        serveHere(state);
    } else if (const auto* moved = std::get_if<RecordedStroke>(&event)) {
        stroke(*moved, state);
    } else if (const auto* wheel = std::get_if<RecordedWheel>(&event)) {
        state.scene.camera = zoomedByWheel(state.scene.camera, wheel->steps);
    } else if (const auto* probe = std::get_if<RecordedProbe>(&event)) {
        probeUnder(state, probe->at, probe->size);
    } else {
        done = edit(std::get<RecordedEdit>(event), state);
    }
    state.history.watch(state, {}, {});
    return done;
}

Result<ExplorerState> startOf(const Recording& recording)
{
    ExplorerState state;
    state.scene = defaultScene();
    const auto json = parsedJson(recording.start, "the start of a recording", {});
    if (!json)
        return json.error();
    if (const auto set = setDocument(*json, state); !set)
        return set.error();
    state.history.watch(state, {}, {});
    return state;
}

Result<ExplorerState> replayed(const Recording& recording)
{
    auto state = startOf(recording);
    for (const RecordedEvent& event : recording.events)
        if (state)
            if (const auto done = replay(event, *state); !done)
                return done.error();
    return state;
}

Recorder::Recorder(const ExplorerState& state)
{
    recording_.start = documentOf(state);
    if (Result<ExplorerState> start = startOf(recording_))
        shadow_ = *std::move(start);
}

void Recorder::note(RecordedEvent event)
{
    // What the program itself recorded fits what it recorded before.
    if (replay(event, shadow_))
        recording_.events.push_back(std::move(event));
}

void Recorder::settle(const ExplorerState& state)
{
    const Json before = jsonOf(shadow_), after = jsonOf(state);
    if (before != after)
        note(RecordedEdit{Json::diff(before, after).dump()});
}

} // namespace reflectance::explorer
