#include "app/cli/scene_options.h"

#include "core/base/number_list.h"
#include "core/base/text.h"
#include "core/geometry/orbit_view.h"
#include "core/scene/library_surface.h"
#include "core/scene/scene_file.h"
#include "core/sensor/fields.h"

#include <cmath>

namespace reflectance::cli {
namespace {

constexpr const char* lightHelp =
    "KIND:X,Y,Z[:I[:RADIUS]] - KIND directional (X,Y,Z points to the light) or point (its position; the object has "
    "radius 1 about the origin); I one number or R,G,B (default 1); RADIUS its angular radius in degrees (default 0). "
    "Repeat for more lights; any --light replaces the scene's.";
constexpr const char* cameraHelp =
    "orbit=AZIMUTH,ELEVATION in degrees (0,0 looks along -z; the object fills the picture) or eye=X,Y,Z; then, each "
    "after a colon, target=X,Y,Z, up=X,Y,Z, fov=DEGREES";

std::optional<Vec3d> vector3(std::string_view text)
{
    const auto numbers = numberList(text);
    if (!numbers || numbers->size() != 3)
        return std::nullopt;
    return Vec3d{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

std::optional<Vec3d> greyOrColor(std::string_view text)
{
    const auto numbers = numberList(text);
    if (numbers && numbers->size() == 1)
        return Vec3d((*numbers)[0]);
    return vector3(text);
}

bool isNegative(const Vec3d& v)
{
    return v.x < 0.0 || v.y < 0.0 || v.z < 0.0;
}

Error badLight(const std::string& text, const std::string& why)
{
    return Error{"--light " + text + ": " + why +
                 "; write KIND:X,Y,Z[:I[:RADIUS]], as in directional:-1,2,2:1,0.9,0.8"};
}

bool setCameraPart(std::string_view key, std::string_view value, double aspect, Camera& camera)
{
    const auto numbers = numberList(value);
    if (!numbers)
        return false;
    if (key == "orbit" && numbers->size() == 2) {
        camera = orbitView(camera, (*numbers)[0], (*numbers)[1], aspect);
        return true;
    }
    if (key == "fov" && numbers->size() == 1 && (*numbers)[0] >= 1.0 && (*numbers)[0] <= 120.0) {
        camera.fieldOfView = (*numbers)[0];
        return true;
    }
    const auto v = vector3(value);
    if (!v || (key != "eye" && key != "target" && key != "up"))
        return false;
    (key == "eye" ? camera.eye : key == "target" ? camera.target : camera.up) = *v;
    return true;
}

Result<void> setEnvironment(const std::string& text, Environment& environment)
{
    if (text == "none" || text == "studio") {
        environment = Environment();
        environment.kind = text == "none" ? EnvironmentKind::None : EnvironmentKind::Studio;
        return {};
    }
    if (text.starts_with("constant:")) {
        const auto radiance = greyOrColor(text.substr(9));
        if (!radiance || isNegative(*radiance))
            return Error{"--environment " + text + ": write constant:R,G,B with numbers that are not negative"};
        environment = Environment();
        environment.kind = EnvironmentKind::Constant;
        environment.radiance = *radiance;
        return {};
    }
    auto loaded = loadEnvironment(text);
    if (!loaded)
        return loaded.error();
    environment = *std::move(loaded);
    return {};
}

Result<void> setBackground(const std::string& text, Background& background)
{
    if (text == "environment") {
        background.kind = BackgroundKind::Environment;
        return {};
    }
    const auto color = greyOrColor(text);
    if (!color || isNegative(*color))
        return Error{"--background " + text + ": write environment, one linear number or R,G,B"};
    background = {BackgroundKind::Plain, *color};
    return {};
}

bool isPicture(const std::string& input)
{
    return lowered(input).ends_with(".png") || lowered(input).ends_with(".exr");
}

/// Scene files and pictures hold a whole scene, its camera included.
bool holdsScene(const std::string& input)
{
    return lowered(input).ends_with(".json") || isPicture(input);
}

Result<Scene> sceneOfPicture(const std::string& input)
{
    auto kept = loadKept(input);
    if (!kept)
        return kept.error();
    return std::move(kept->scene);
}

Result<Scene> openInput(const std::string& input, bool smooth)
{
    const bool isScene = holdsScene(input);
    auto scene = isPicture(input) ? sceneOfPicture(input) : isScene ? loadScene(input) : Result(defaultScene());
    if (!scene || (!smooth && (isScene || input.empty())))
        return scene;
    if (!isScene && !input.empty())
        scene->meshFile = input;
    scene->recomputeNormals = scene->recomputeNormals || smooth;
    if (const auto read = readMeshOf(*scene); !read)
        return read.error();
    return scene;
}

Result<void> setSensor(const SceneOptions& options, Sensor& sensor)
{
    for (const std::string& assignment : options.sensor)
        if (const auto set = setOnSensor(assignment, sensor); !set)
            return Error{"--sensor " + assignment + ": " + set.error().message};
    sensor.view.marks = sensor.view.marks || options.markClipped;
    for (const auto& kind : sensorViewKinds)
        if (kind.name == options.view)
            sensor.view.kind = kind.value;
    return {};
}

Result<void> setLights(const SceneOptions& options, std::vector<Light>& lights)
{
    if (!options.lights.empty())
        lights.clear();
    for (const std::string& text : options.lights) {
        auto light = parseLight(text);
        if (!light)
            return light.error();
        light->name = "light " + std::to_string(lights.size() + 1);
        lights.push_back(*std::move(light));
    }
    return {};
}

} // namespace

void addSurfaceOptions(CLI::App& verb, SceneOptions& options)
{
    verb.add_option("--surface", options.surface,
                    "a surface of the library, by id or name: its model and parameters; 'reflectance surfaces' lists "
                    "them; --model and --set come after it");
    verb.add_option("--model", options.model, "reflectance model; 'reflectance models' lists them");
    verb.add_option("--model-file", options.modelFile,
                    "a model of your own: a text under the rules of shaders/README.md");
    verb.add_option("--set", options.assignments,
                    "NAME=VALUE of a model parameter; matrices row by row, numbers parted by commas; file=PATH of a "
                    "measured table");
}

Result<void> setSurface(const SceneOptions& options, Surface& surface)
{
    if (!options.surface.empty()) {
        const auto found = findSurface(options.surface);
        if (!found)
            return Error{"--surface: " + found.error().message};
        applySurface(**found, surface);
    }
    if (!options.model.empty()) {
        const auto model = findModel(options.model);
        if (!model)
            return model.error();
        surface.model = options.model;
    }
    if (!options.modelFile.empty()) {
        if (!options.model.empty())
            return Error{"--model-file brings its model; leave --model out"};
        if (const auto read = readModelOf(surface, options.modelFile); !read)
            return read.error();
    }
    for (const std::string& assignment : options.assignments)
        if (const auto set = setOnSurface(assignment, surface); !set)
            return Error{"--set " + assignment + ": " + set.error().sentence()};
    if (const auto complete = checkSurface(surface); !complete)
        return Error{"--set: " + complete.error().message};
    surface.showHoles = options.showHoles;
    return {};
}

void addSceneOptions(CLI::App& verb, SceneOptions& options)
{
    verb.add_option(
        "input", options.input,
        "mesh (OBJ, PLY, OFF, STL), stock mesh name, scene file (.json) or a picture that this program saved "
        "(.png, .exr); default: the mug");
    verb.add_flag("--smooth", options.smooth, "compute the normals anew: faceted files look round");
    verb.add_option("--size", options.size, "WxH in pixels");
    verb.add_option("--samples", options.samples, "samples per pixel: 1, 4, 9, 16, 25, 36, 49 or 64 (default 4)");
    addSurfaceOptions(verb, options);
    verb.add_flag("--holes", options.showHoles, "stripes where a measured table has no value, instead of black");
    verb.add_option("--light", options.lights, lightHelp);
    verb.add_option("--camera", options.camera, cameraHelp);
    verb.add_option("--environment", options.environment,
                    "none, studio, constant:R,G,B, or a latitude-longitude picture (.exr, .hdr)");
    verb.add_option("--background", options.background, "environment, or a linear colour R,G,B");
    verb.add_option("--exposure", options.exposure, "EV: radiance times 2^EV before the sensor, -16 .. 16");
    verb.add_option(
        "--sensor", options.sensor,
        "PART=VALUE[:KEY=VALUE...] of the sensor, VALUE being on, off or that of the part's first key, as in "
        "noise=8:seed=3, quantisation=10, encoding=rec709, response=curve:file=CURVE.csv, well=off, or all=off; the "
        "parts "
        "and their keys: " +
            sensorGrammar());
    verb.add_option("--view", options.view,
                    "what a PNG shows: picture, luminance or false-colour (one colour per stop)")
        ->check(CLI::IsMember(namesIn(sensorViewKinds)));
    verb.add_flag("--mark-clipped", options.markClipped,
                  "paint stripes where a PNG is clipped (orange) or negative (blue), magenta where it is no number");
}

Result<Light> parseLight(const std::string& text)
{
    const auto fields = split(text, ':');
    Light light;
    if (fields[0] == "point")
        light.kind = LightKind::Point;
    else if (fields[0] != "directional")
        return badLight(text, "its kind is neither directional nor point");
    const auto place = fields.size() > 1 ? vector3(fields[1]) : std::nullopt;
    if (!place || fields.size() > 4)
        return badLight(text, "three numbers must follow the kind");
    if (light.kind == LightKind::Directional && normalized(*place) == Vec3d())
        return badLight(text, "the direction is the zero vector");
    (light.kind == LightKind::Point ? light.position : light.direction) = *place;
    if (fields.size() > 2) {
        const auto intensity = greyOrColor(fields[2]);
        if (!intensity || isNegative(*intensity))
            return badLight(text, "the intensity must be one or three numbers that are not negative");
        light.intensity = *intensity;
    }
    if (fields.size() > 3) {
        const auto radius = parseNumber(fields[3]);
        if (!radius || !(*radius >= 0.0 && *radius <= 90.0))
            return badLight(text, "the angular radius must be within 0 .. 90 degrees");
        light.angularRadius = *radius;
    }
    return light;
}

Result<Camera> parseCamera(const std::string& text, Camera camera, double aspect)
{
    for (const std::string_view part : split(text, ':')) {
        const std::size_t equals = std::min(part.find('='), part.size());
        const std::string_view value = part.substr(std::min(equals + 1, part.size()));
        if (!setCameraPart(part.substr(0, equals), value, aspect, camera))
            return Error{"--camera: cannot read '" + std::string(part) + "'; write " + cameraHelp};
    }
    if (normalized(camera.eye - camera.target) == Vec3d())
        return Error{"--camera: eye and target are the same point; move one of them"};
    return camera;
}

Result<std::optional<PictureRecipe>> recipeOf(const SceneOptions& options)
{
    if (!isPicture(options.input))
        return std::optional<PictureRecipe>();
    const auto kept = loadKept(options.input);
    if (!kept)
        return kept.error();
    return std::optional(kept->recipe);
}

Result<RenderSettings> settingsFrom(const SceneOptions& options, RenderSettings fallback)
{
    if (options.size.empty())
        return checkedSettings(fallback.width, fallback.height, options.samples.value_or(4));
    const auto sides = split(options.size, 'x');
    const auto width = parseInteger(sides[0]);
    const auto height = sides.size() == 2 ? parseInteger(sides[1]) : std::nullopt;
    if (!width || !height || std::abs(*width) > 1000000 || std::abs(*height) > 1000000)
        return Error{"--size " + options.size + ": write WIDTHxHEIGHT, as in 1024x768"};
    return checkedSettings(static_cast<int>(*width), static_cast<int>(*height), options.samples.value_or(4));
}

Result<Scene> sceneFrom(const SceneOptions& options)
{
    const auto settings = settingsFrom(options);
    if (!settings)
        return settings.error();
    const double aspect = static_cast<double>(settings->width) / settings->height;
    auto scene = openInput(options.input, options.smooth);
    if (!scene)
        return scene;
    if (!holdsScene(options.input))
        scene->camera = framed(scene->camera, aspect);
    if (!options.camera.empty()) {
        auto camera = parseCamera(options.camera, scene->camera, aspect);
        if (!camera)
            return camera.error();
        scene->camera = *camera;
    }
    if (const auto set = setSurface(options, scene->surface); !set)
        return set.error();
    if (scene->other)
        scene->other->showHoles = options.showHoles;
    if (const auto set = setLights(options, scene->lights); !set)
        return set.error();
    if (!options.environment.empty())
        if (const auto set = setEnvironment(options.environment, scene->environment); !set)
            return set.error();
    if (!options.background.empty())
        if (const auto set = setBackground(options.background, scene->background); !set)
            return set.error();
    if (options.exposure) {
        if (!(std::fabs(*options.exposure) <= 16.0))
            return Error{"--exposure " + general(*options.exposure, 6) + " is out of range; give a value in -16 .. 16"};
        scene->sensor.exposure = *options.exposure;
    }
    if (const auto set = setSensor(options, scene->sensor); !set)
        return set.error();
    return scene;
}

} // namespace reflectance::cli
