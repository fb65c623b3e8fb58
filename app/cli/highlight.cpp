#include "app/cli/highlight.h"

#include "core/base/number_list.h"
#include "core/study/grab/grab.h"

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

} // namespace

Result<std::size_t> putHighlight(const std::string& text, const RenderSettings& settings, Scene& scene)
{
    const std::string flag = "--highlight-at " + text + ": ";
    const auto numbers = numberList(text);
    if (!numbers || numbers->size() < 2 || numbers->size() > 3)
        return Error{flag + "write X,Y in pixels from the upper left corner, or X,Y,LIGHT, as in 320,240.5,1"};
    const auto light = chosenLight(*numbers, scene);
    if (!light)
        return Error{flag + light.error().message};
    const auto point =
        pointAt(*scene.mesh, scene.camera, (*numbers)[0], (*numbers)[1], settings.width, settings.height);
    if (!point)
        return Error{flag + "the object is not seen there; the picture is " + std::to_string(settings.width) + "x" +
                     std::to_string(settings.height)};
    auto moved = withSpotAt(scene.lights[*light], scene.camera.eye, *point, spotKindOf(scene));
    if (!moved)
        return Error{flag + moved.error().message};
    scene.lights[*light] = *std::move(moved);
    return *light;
}

nlohmann::ordered_json lightReport(const Light& light, std::size_t index)
{
    const bool directional = light.kind == LightKind::Directional;
    const Vec3d& place = directional ? light.direction : light.position;
    return {{"light", index + 1}, {directional ? "direction" : "position", {place.x, place.y, place.z}}};
}

} // namespace reflectance::cli
