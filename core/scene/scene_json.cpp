#include "core/scene/scene_json.h"

#include "core/geometry/load.h"
#include "core/reflectance/lists.h"
#include "core/scene/library_surface.h"
#include "core/scene/names.h"
#include "core/scene/rung_list.h"
#include "core/scene/sensor_file.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

namespace reflectance {
namespace {

using Json = ObjectReader::Json;
namespace fs = std::filesystem;

constexpr NamedValue<LightKind> lightKinds[] = {{"directional", LightKind::Directional}, {"point", LightKind::Point}};
constexpr NamedValue<EnvironmentKind> environmentKinds[] = {{"none", EnvironmentKind::None},
                                                            {"constant", EnvironmentKind::Constant},
                                                            {"studio", EnvironmentKind::Studio},
                                                            {"map", EnvironmentKind::Map}};
constexpr NamedValue<BackgroundKind> backgroundKinds[] = {{"plain", BackgroundKind::Plain},
                                                          {"environment", BackgroundKind::Environment}};

constexpr NamedValue<Convention> conventions[] = {{"sensor", Convention::Sensor}, {"primary", Convention::Primary}};

Json array(const Vec3d& v)
{
    return Json::array({v.x, v.y, v.z});
}

/// A path as the scene file writes it, and back. What does not lie below the folder is written from the root: the file
/// may be read from anywhere.
std::string writtenPath(const ScenePaths& paths, const std::string& path)
{
    if (path.empty())
        return path;
    std::error_code failed;
    const fs::path here = fs::current_path(failed);
    if (failed) // the current folder has been removed
        return path;
    const fs::path whole = (here / path).lexically_normal();
    const fs::path relative = whole.lexically_relative((here / paths.folder).lexically_normal());
    const bool below = !paths.fromRoot && !relative.empty() && *relative.begin() != "..";
    return below ? relative.string() : whole.string();
}

bool isThere(const fs::path& path)
{
    std::error_code ignored;
    return fs::exists(path, ignored);
}

/// What is no longer where it was may have been moved together with the file that names it.
std::string resolvedPath(const ScenePaths& paths, const std::string& path)
{
    const fs::path folder(paths.folder);
    const fs::path place = fs::path(path).is_absolute() ? fs::path(path) : (folder / path).lexically_normal();
    if (paths.folderBefore.empty() || isThere(place))
        return place.string();
    const fs::path beside = (folder / place.lexically_relative(paths.folderBefore)).lexically_normal();
    return isThere(beside) ? beside.string() : place.string();
}

bool isStockMesh(const std::string& name)
{
    const std::vector<std::string> names = stockMeshNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

Json written(const Light& light)
{
    Json json{{"name", light.name}, {"kind", nameOf(lightKinds, light.kind)}};
    if (light.kind == LightKind::Directional)
        json["direction"] = array(light.direction);
    else
        json["position"] = array(light.position);
    json["intensity"] = array(light.intensity);
    json["radius"] = light.angularRadius;
    json["on"] = light.on;
    return json;
}

Json written(const Environment& environment, const ScenePaths& paths)
{
    Json json{{"kind", nameOf(environmentKinds, environment.kind)},
              {"radiance", array(environment.radiance)},
              {"rotation", environment.rotation}};
    if (environment.kind == EnvironmentKind::Map)
        json["file"] = writtenPath(paths, environment.file);
    return json;
}

/// One number, or three that are the same: a colour without hue, which reads back from one.
bool isGrey(const std::vector<double>& numbers)
{
    return numbers.size() == 1 || (numbers.size() == 3 && numbers[0] == numbers[1] && numbers[1] == numbers[2]);
}

Json written(const Surface& surface, const ScenePaths& paths)
{
    Json parameters = Json::object();
    for (const auto& [name, numbers] : surface.values)
        parameters[name] = isGrey(numbers) ? Json(numbers.front()) : Json(numbers);
    Json json{{"model", surface.model}, {"parameters", parameters}, {"convention", nameOf(surface.convention)}};
    if (surface.convention == Convention::Primary)
        json["W"] = surface.W;
    if (!surface.tableFile.empty())
        json["file"] = writtenPath(paths, surface.tableFile);
    if (surface.own && !surface.modelFile.empty())
        json["model_file"] = writtenPath(paths, surface.modelFile);
    if (!surface.rungs.empty())
        json["rungs"] = surface.rungs;
    return json;
}

Json written(const Pin& pin, const Scene& scene, const ScenePaths& paths)
{
    Json json{{"name", pin.name}, {"at", array(pin.P)}, {"triangle", pin.triangle}};
    if (pin.meshFile != scene.meshFile)
        json["mesh"] = isStockMesh(pin.meshFile) ? pin.meshFile : writtenPath(paths, pin.meshFile);
    return json;
}

void readCamera(ObjectReader object, Camera& camera)
{
    object.read("eye", camera.eye);
    object.read("target", camera.target);
    object.read("up", camera.up);
    object.read("field_of_view", camera.fieldOfView, 1.0, 120.0);
    object.finish();
}

void readLight(ObjectReader object, Light& light)
{
    object.read("name", light.name);
    object.readNamed("kind", lightKinds, light.kind);
    object.read("direction", light.direction);
    object.read("position", light.position);
    object.read("intensity", light.intensity, 0.0);
    object.read("radius", light.angularRadius, 0.0, 90.0);
    object.read("on", light.on);
    if (normalized(light.direction) == Vec3d())
        object.fail("direction of light '" + light.name + "' is the zero vector; give a direction");
    object.finish();
}

void readEnvironment(ObjectReader object, Environment& environment, const ScenePaths& paths)
{
    object.readNamed("kind", environmentKinds, environment.kind);
    object.read("radiance", environment.radiance, 0.0);
    object.read("rotation", environment.rotation);
    object.read("file", environment.file);
    object.finish();
    if (environment.kind != EnvironmentKind::Map)
        return;
    auto loaded = loadEnvironment(resolvedPath(paths, environment.file));
    if (!loaded)
        return object.fail(loaded.error().sentence());
    environment.map = loaded->map;
    environment.file = loaded->file;
}

void readBackground(ObjectReader object, Background& background)
{
    object.readNamed("kind", backgroundKinds, background.kind);
    object.read("color", background.color, 0.0);
    object.finish();
}

void readConvention(ObjectReader& object, Surface& surface)
{
    object.readNamed("convention", conventions, surface.convention);
    object.read("W", surface.W);
    if (surface.convention == Convention::Sensor)
        surface.W = Surface().W;
    const auto& W = surface.W;
    if (!(conditionNumber({{{W[0], W[1], W[2]}, {W[3], W[4], W[5]}, {W[6], W[7], W[8]}}}) < largestCondition))
        object.fail("W is singular; give nine numbers row by row, what each sensor sees of each primary on white");
}

void readSurface(ObjectReader object, Surface& surface, const ScenePaths& paths)
{
    std::string library;
    object.read("library", library);
    if (!library.empty()) {
        const auto found = findSurface(library);
        if (!found)
            return object.fail(found.error().message);
        applySurface(**found, surface);
    }
    std::string modelFile;
    object.read("model_file", modelFile);
    if (!modelFile.empty())
        if (const auto read = readModelOf(surface, resolvedPath(paths, modelFile)); !read)
            return object.fail(read.error().sentence());
    object.read("model", surface.model);
    const auto model = findModelOf(surface);
    if (!model)
        return object.fail(model.error().message);
    std::vector<const Model*> known{*model};
    for (const Model& other : catalogue())
        known.push_back(&other);
    object.eachNumberList("parameters", [&](const std::string& name, const std::vector<double>& numbers) {
        // A parameter that only other models know is kept for them.
        for (const Model* other : known) {
            const Parameter* parameter = other->text.find(name);
            if (!parameter)
                continue;
            auto checked = checkedValue(*parameter, numbers);
            if (!checked)
                return object.fail(checked.error().message);
            surface.values[name] = *std::move(checked);
            return;
        }
        object.fail("no model has a parameter '" + name + "'");
    });
    for (const Model* other : known)
        if (const auto agree = checkLists(other->text, surface.values); !agree)
            object.fail(agree.error().message);
    readConvention(object, surface);
    object.readTexts("rungs", surface.rungs);
    if (const auto possible = checkRungs(surface.rungs); !possible)
        object.fail(possible.error().message);
    std::string file;
    object.read("file", file);
    if (!file.empty())
        if (const auto read = readTableOf(surface, resolvedPath(paths, file)); !read)
            object.fail(read.error().sentence());
    object.finish();
}

void readVariants(ObjectReader& object, Scene& scene, const ScenePaths& paths)
{
    object.readList("variants", scene.variants, [&](ObjectReader part, KeptSurface& variant) {
        part.read("name", variant.name);
        part.readObject("surface",
                        [&](ObjectReader surface) { readSurface(std::move(surface), variant.surface, paths); });
        part.finish();
        if (const std::string problem = nameProblem(scene.variants, "variant"); !problem.empty())
            part.fail(problem);
    });
}

/// Of the scene's own object; those of another one wait for it.
void checkPin(ObjectReader& object, const Pin& pin, const Scene& scene)
{
    const std::size_t triangles = scene.mesh ? scene.mesh->triangles.size() : 0;
    if (pin.meshFile == scene.meshFile && pin.triangle >= triangles)
        object.fail("pin '" + pin.name + "' lies on triangle " + std::to_string(pin.triangle) + ", and the mesh has " +
                    std::to_string(triangles) + "; remove the pin, or give the mesh that it was put on");
}

/// After the mesh.
void readPins(ObjectReader& object, Scene& scene, const ScenePaths& paths)
{
    object.readList("pins", scene.pins, [&](ObjectReader part, Pin& pin) {
        int triangle = 0;
        part.read("name", pin.name);
        part.read("at", pin.P);
        part.read("triangle", triangle, 0, std::numeric_limits<int>::max());
        part.read("mesh", pin.meshFile);
        part.finish();
        pin.triangle = static_cast<std::uint32_t>(triangle);
        if (pin.meshFile.empty())
            pin.meshFile = scene.meshFile;
        else if (!isStockMesh(pin.meshFile))
            pin.meshFile = resolvedPath(paths, pin.meshFile);
        if (const std::string problem = nameProblem(scene.pins, "pin"); !problem.empty())
            part.fail(problem);
        checkPin(part, pin, scene);
    });
    if (scene.pins.size() > mostPins)
        object.fail("a scene keeps at most " + std::to_string(mostPins) + " pins; remove some");
}

void readMeshKeys(ObjectReader& object, Scene& scene, const ScenePaths& paths)
{
    const std::string before = scene.meshFile;
    object.read("mesh", scene.meshFile);
    object.read("smooth_normals", scene.recomputeNormals);
    if (scene.meshFile == before && !scene.recomputeNormals)
        return;
    if (!isStockMesh(scene.meshFile))
        scene.meshFile = resolvedPath(paths, scene.meshFile);
    if (const auto read = readMeshOf(scene); !read)
        object.fail(read.error().sentence());
}

/// The first versions were named by one key, "reflectance_scene".
void readVersion(ObjectReader& object)
{
    int first = 1;
    object.read("reflectance_scene", first, 1, 1);
    object.readVersion(sceneSchema, sceneFormatVersion);
}

} // namespace

void readScene(ObjectReader object, Scene& scene, const ScenePaths& paths)
{
    readVersion(object);
    readMeshKeys(object, scene, paths);
    object.readObject("camera", [&](ObjectReader part) { readCamera(std::move(part), scene.camera); });
    object.readList("lights", scene.lights, readLight);
    object.readObject("environment",
                      [&](ObjectReader part) { readEnvironment(std::move(part), scene.environment, paths); });
    object.readObject("background", [&](ObjectReader part) { readBackground(std::move(part), scene.background); });
    object.readObject("surface", [&](ObjectReader part) { readSurface(std::move(part), scene.surface, paths); });
    object.readObject("compare",
                      [&](ObjectReader part) { readSurface(std::move(part), scene.other.emplace(), paths); });
    readVariants(object, scene, paths);
    readPins(object, scene, paths);
    object.readObject("sensor", [&](ObjectReader part) {
        readSensor(std::move(part), scene.sensor, [&](const std::string& path) { return resolvedPath(paths, path); });
    });
    object.finish();
}

Json sceneJson(const Scene& scene, const ScenePaths& paths)
{
    Json lights = Json::array();
    for (const Light& light : scene.lights)
        lights.push_back(written(light));
    Json json{
        {"schema", sceneSchema},
        {"version", sceneFormatVersion},
        {"mesh", isStockMesh(scene.meshFile) ? scene.meshFile : writtenPath(paths, scene.meshFile)},
        {"smooth_normals", scene.recomputeNormals},
        {"camera",
         {{"eye", array(scene.camera.eye)},
          {"target", array(scene.camera.target)},
          {"up", array(scene.camera.up)},
          {"field_of_view", scene.camera.fieldOfView}}},
        {"lights", lights},
        {"environment", written(scene.environment, paths)},
        {"background",
         {{"kind", nameOf(backgroundKinds, scene.background.kind)}, {"color", array(scene.background.color)}}},
        {"surface", written(scene.surface, paths)},
        {"sensor", writtenSensor(scene.sensor, [&](const std::string& path) { return writtenPath(paths, path); })}};
    if (scene.other)
        json["compare"] = written(*scene.other, paths);
    for (const KeptSurface& variant : scene.variants)
        json["variants"].push_back({{"name", variant.name}, {"surface", written(variant.surface, paths)}});
    for (const Pin& pin : scene.pins)
        json["pins"].push_back(written(pin, scene, paths));
    return json;
}

} // namespace reflectance
