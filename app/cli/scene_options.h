// The flags that describe a scene, shared by every verb that takes one: --model, --set, --light, --camera, ...
#pragma once

#include "core/base/result.h"
#include "core/render/settings.h"
#include "core/scene/kept_picture.h"
#include "core/scene/scene.h"

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::cli {

struct SceneOptions {
    std::string input;   ///< mesh, stock mesh name, scene file or saved picture; empty: the default scene
    bool smooth = false; ///< normals computed anew
    std::string size;
    std::optional<int> samples; ///< per pixel; none: 4, or as a saved picture has
    std::string surface;        ///< of the library; empty: none
    std::string model;
    std::string modelFile; ///< of an own model; empty: none
    std::vector<std::string> assignments;
    bool showHoles = false;
    std::vector<std::string> lights;
    std::string camera;
    std::string environment;
    std::string background;
    std::optional<double> exposure;
    std::vector<std::string> sensor; ///< "PART=VALUE[:KEY=VALUE...]"
    std::string view;                ///< of the sensor
    bool markClipped = false;
};

void addSceneOptions(CLI::App& verb, SceneOptions& options);

/// --surface, --model, --model-file and --set: those of them that describe the surface.
void addSurfaceOptions(CLI::App& verb, SceneOptions& options);

/// Puts what they say on the surface; an error leaves it half done.
[[nodiscard]] Result<void> setSurface(const SceneOptions& options, Surface& surface);

/// The scene that the flags describe.
[[nodiscard]] Result<Scene> sceneFrom(const SceneOptions& options);

/// How a picture that is the input was made; none where the input is something else.
[[nodiscard]] Result<std::optional<PictureRecipe>> recipeOf(const SceneOptions& options);

/// Size and samples, checked. `fallback` is used where --size was not given.
[[nodiscard]] Result<RenderSettings> settingsFrom(const SceneOptions& options, RenderSettings fallback = {});

/// "directional:X,Y,Z[:I[:RADIUS]]" or "point:X,Y,Z[:I[:RADIUS]]", I one or three numbers.
[[nodiscard]] Result<Light> parseLight(const std::string& text);

/// "orbit=AZIMUTH,ELEVATION" (degrees) or "eye=X,Y,Z", then ":target=X,Y,Z", ":up=X,Y,Z", ":fov=DEGREES".
[[nodiscard]] Result<Camera> parseCamera(const std::string& text, Camera camera, double aspect);

} // namespace reflectance::cli
