#include "app/cli/highlight.h"

#include "core/base/number_list.h"
#include "core/study/grab/grab.h"
#include "core/study/grab/width.h"

#include <algorithm>

namespace reflectance::cli {
namespace {

/// The light with this number, or the first that is on.
Result<std::size_t> chosenLight(const std::vector<double>& numbers, const Scene& scene)
{
    const auto& lights = scene.lights;
    const auto on = std::find_if(lights.begin(), lights.end(), [](const Light& light) { return light.on; });
    if (numbers.size() == 3) {
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (numbers[2] == static_cast<double>(i + 1))
                return i;
        return Error{"the scene has the lights 1 .. " + std::to_string(lights.size()) + "; name one of them"};
    }
    if (on == lights.end())
        return Error{"no light is on; give the scene one by --light"};
    return static_cast<std::size_t>(on - lights.begin());
}

/// A point of the object, and a light.
struct Aim {
    ProbedPoint point;
    std::size_t light = 0;
};

Result<Aim> aimOf(const std::string& flag, const std::string& text, const RenderSettings& settings, const Scene& scene)
{
    const std::string said = flag + " " + text + ": ";
    const auto numbers = numberList(text);
    if (!numbers || numbers->size() < 2 || numbers->size() > 3)
        return Error{said + "write X,Y in pixels from the upper left corner, or X,Y,LIGHT, as in 320,240.5,1"};
    const auto light = chosenLight(*numbers, scene);
    if (!light)
        return Error{said + light.error().message};
    const auto point =
        pointAt(*scene.mesh, scene.camera, (*numbers)[0], (*numbers)[1], settings.width, settings.height);
    if (!point)
        return Error{said + "the object is not seen there; the picture is " + std::to_string(settings.width) + "x" +
                     std::to_string(settings.height)};
    return Aim{*point, *light};
}

} // namespace

Result<std::size_t> putHighlight(const std::string& text, const RenderSettings& settings, Scene& scene)
{
    const auto aim = aimOf("--highlight-at", text, settings, scene);
    if (!aim)
        return aim.error();
    auto moved = withSpotAt(scene.lights[aim->light], scene.camera.eye, aim->point, spotKindOf(scene));
    if (!moved)
        return Error{"--highlight-at " + text + ": " + moved.error().message};
    scene.lights[aim->light] = *std::move(moved);
    return aim->light;
}

Result<std::pair<std::string, double>> putEdge(const std::string& text, const RenderSettings& settings, Scene& scene)
{
    const auto aim = aimOf("--edge-at", text, settings, scene);
    if (!aim)
        return aim.error();
    const auto width = spotWidthOf(scene);
    if (!width)
        return Error{"--edge-at " + text + ": " + modelOf(scene).text.name +
                     " has no highlight whose width is a number of the model; choose one that has, phong or ggx"};
    const double value = widthWithHeightAt(scene, *width, scene.lights[aim->light], aim->point, edgeHeight);
    const std::string name = width->parameter->name;
    scene.surface.values[name] = {value};
    return std::pair(name, value);
}

nlohmann::ordered_json lightReport(const Light& light, std::size_t index)
{
    const bool directional = light.kind == LightKind::Directional;
    const Vec3d& place = directional ? light.direction : light.position;
    return {{"light", index + 1}, {directional ? "direction" : "position", {place.x, place.y, place.z}}};
}

} // namespace reflectance::cli
