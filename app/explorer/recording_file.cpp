// Recordings as JSON.
#include "app/explorer/recording.h"

#include "core/base/file.h"
#include "core/scene/json_reader.h"

namespace reflectance::explorer {
namespace {

using Json = ObjectReader::Json;

constexpr const char* schema = "reflectance.recording";
constexpr int newestVersion = 1;
constexpr NamedValue<MouseButton> buttonNames[] = {
    {"left", MouseButton::Left}, {"right", MouseButton::Right}, {"middle", MouseButton::Middle}};
constexpr NamedValue<Grip> gripNames[] = {{"spot", Grip::Spot}, {"edge", Grip::Edge}, {"terminator", Grip::Terminator}};
constexpr int mostLights = 1000000, mostPixels = 65536;

Json written(const KeyPress& key)
{
    return {{"key", key.key}, {"control", key.control}, {"shift", key.shift}};
}

Json written(const RecordedStroke& stroke)
{
    Json json{{"stroke", buttonNames[static_cast<std::size_t>(stroke.button)].name},
              {"control", stroke.modifiers.control},
              {"shift", stroke.modifiers.shift},
              {"width", stroke.size.width},
              {"height", stroke.size.height},
              {"handle", stroke.handle},
              {"selected", stroke.selected},
              {"from_x", stroke.from.x},
              {"from_y", stroke.from.y},
              {"to_x", stroke.to.x},
              {"to_y", stroke.to.y}};
    if (stroke.grasp) {
        json["grip"] = gripNames[static_cast<std::size_t>(stroke.grasp->grip)].name;
        json["grip_light"] = stroke.grasp->light;
    }
    return json;
}

Json written(const RecordedWheel& wheel)
{
    return {{"wheel", wheel.steps}};
}

Json written(const RecordedProbe& probe)
{
    return {
        {"probe_x", probe.at.x}, {"probe_y", probe.at.y}, {"width", probe.size.width}, {"height", probe.size.height}};
}

Json written(const RecordedEdit& edit)
{
    return {{"edit", Json::parse(edit.patch)}};
}

KeyPress readKey(ObjectReader& object)
{
    KeyPress key;
    object.read("key", key.key);
    object.read("control", key.control);
    object.read("shift", key.shift);
    return key;
}

std::optional<Grasp> readGrasp(ObjectReader& object)
{
    Grasp grasp;
    int light = 0;
    object.readNamed("grip", gripNames, grasp.grip);
    object.read("grip_light", light, 0, mostLights);
    grasp.light = static_cast<std::size_t>(light);
    return grasp;
}

RecordedStroke readStroke(ObjectReader& object)
{
    RecordedStroke stroke;
    object.readNamed("stroke", buttonNames, stroke.button);
    object.read("control", stroke.modifiers.control);
    object.read("shift", stroke.modifiers.shift);
    object.read("width", stroke.size.width, 1, mostPixels);
    object.read("height", stroke.size.height, 1, mostPixels);
    object.read("handle", stroke.handle, -1, mostLights);
    object.read("selected", stroke.selected, -1, mostLights);
    object.read("from_x", stroke.from.x);
    object.read("from_y", stroke.from.y);
    object.read("to_x", stroke.to.x);
    object.read("to_y", stroke.to.y);
    if (object.find("grip"))
        stroke.grasp = readGrasp(object);
    return stroke;
}

RecordedProbe readProbe(ObjectReader& object)
{
    RecordedProbe probe;
    object.read("probe_x", probe.at.x);
    object.read("probe_y", probe.at.y);
    object.read("width", probe.size.width, 1, mostPixels);
    object.read("height", probe.size.height, 1, mostPixels);
    return probe;
}

RecordedEvent readEvent(const Json& json, const std::string& name, ObjectReader& object)
{
    if (json.contains("key"))
        return readKey(object);
    if (json.contains("stroke"))
        return readStroke(object);
    if (json.contains("probe_x"))
        return readProbe(object);
    RecordedWheel wheel;
    if (json.contains("wheel"))
        object.read("wheel", wheel.steps, -1000.0, 1000.0);
    else
        object.fail(name + " is none of 'key', 'stroke', 'wheel', 'probe_x' and 'edit'");
    return wheel;
}

void readEvents(const Json& json, Recording& recording, std::optional<std::string>& problem)
{
    for (const Json& event : json) {
        const std::string name = "event " + std::to_string(recording.events.size() + 1);
        ObjectReader object(event, name, problem);
        if (problem)
            return;
        if (event.contains("edit")) {
            recording.events.emplace_back(RecordedEdit{event["edit"].dump()});
            continue;
        }
        recording.events.push_back(readEvent(event, name, object));
        object.finish();
    }
}

} // namespace

std::string recordingText(const Recording& recording)
{
    Json events = Json::array();
    for (const RecordedEvent& event : recording.events)
        events.push_back(std::visit([](const auto& one) { return written(one); }, event));
    return jsonText({{"schema", schema},
                     {"version", newestVersion},
                     {"start", Json::parse(recording.start)},
                     {"events", std::move(events)}});
}

Result<Recording> parseRecording(std::string_view text, const std::string& file)
{
    const auto json = parsedJson(text, "a recording in JSON", file);
    if (!json)
        return json.error();
    std::optional<std::string> problem;
    ObjectReader object(*json, "recording", problem);
    object.readVersion(schema, newestVersion);
    if (!problem && (!json->contains("start") || !json->contains("events") || !(*json)["events"].is_array()))
        problem = "a recording needs 'start' and a list of 'events'";
    Recording recording;
    if (!problem) {
        recording.start = (*json)["start"].dump();
        readEvents((*json)["events"], recording, problem);
    }
    if (problem)
        return Error{*problem, file};
    return recording;
}

Result<Recording> loadRecording(const std::string& path)
{
    const auto text = readWholeFile(path);
    return text ? parseRecording(*text, path) : Result<Recording>(text.error());
}

} // namespace reflectance::explorer
