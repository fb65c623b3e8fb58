#include "core/scene/requirements.h"

#include "core/reflectance/viewer.h"

#include <algorithm>

namespace reflectance {
namespace {

bool isBlack(const Environment& environment)
{
    return environment.kind == EnvironmentKind::None || environment.radiance == Vec3d();
}

bool shines(const Light& light)
{
    return light.on && !(light.intensity == Vec3d());
}

bool anyLight(const Scene& scene, LightKind kind)
{
    return std::any_of(scene.lights.begin(), scene.lights.end(),
                       [kind](const Light& light) { return shines(light) && light.kind == kind; });
}

} // namespace

std::string Requirements::key() const
{
    std::string text = (own ? own->text.file + own->text.code : model) + form.key();
    const auto append = [&text](bool required, std::string_view name) {
        if (required)
            text.append("+").append(name);
    };
    append(directionalLights, "directional");
    append(pointLights, "point");
    append(environment, "environment");
    append(environmentBackground, "background");
    append(environmentMap, "map");
    append(table, "table");
    append(holes, "holes");
    append(!positions, "anywhere");
    append(lobe != LobeForm::Conditioned, factsOf(lobe).name);
    return text;
}

const Model& Requirements::modelUsed() const
{
    return own ? *own : **findModel(model);
}

RequiredModel requiredSurface(const Scene& scene, const Arithmetic& arithmetic)
{
    const std::vector<double> values = valuesOf(scene);
    const Model& model = modelOf(scene);
    const bool isOwn = scene.surface.own.get() == &model; // nothing is known of its limits
    RequiredModel required =
        arithmetic.specialised && !isOwn ? requiredModel(model, values) : generalModel(model, values);
    if (arithmetic.lobe != LobeForm::Conditioned && required.model->text.usesLobe)
        required.form = {}; // the other forms of the lobe have the general kernels alone
    return required;
}

Requirements requirementsOf(const Scene& scene, const Arithmetic& arithmetic)
{
    const RequiredModel required = requiredSurface(scene, arithmetic);
    const Model& model = *required.model;
    Requirements r;
    r.model = model.id();
    r.form = required.form;
    if (scene.surface.own.get() == &model)
        r.own = scene.surface.own;
    r.directionalLights = anyLight(scene, LightKind::Directional);
    r.pointLights = anyLight(scene, LightKind::Point);
    r.environment = model.text.usesEnvironment && !isBlack(scene.environment);
    r.environmentBackground = scene.background.kind == BackgroundKind::Environment && !isBlack(scene.environment);
    r.environmentMap = (r.environment || r.environmentBackground) && scene.environment.kind == EnvironmentKind::Map;
    r.table = model.text.usesTable && scene.surface.table != nullptr;
    r.lobe = model.text.usesLobe ? arithmetic.lobe : LobeForm::Conditioned;
    r.holes = r.table && scene.surface.showHoles;
    r.positions = !arithmetic.specialised || r.pointLights || r.holes || r.form.facing || looksAtViewer(model.text);
    return r;
}

std::vector<std::string> leftOut(const Scene& scene)
{
    const Model& model = modelOf(scene);
    std::vector<std::string> notes = requiredSurface(scene).leftOut;
    if (!requirementsOf(scene).positions)
        notes.push_back("where the samples lie, 16 bytes each in GL: " + requiredSurface(scene).model->text.name +
                        " looks alike from everywhere, and no light is near");
    if (!model.text.usesEnvironment && !isBlack(scene.environment))
        notes.push_back("environment: " + model.text.name + " is lit by the lights alone");
    if (model.text.usesTable && !scene.surface.table)
        notes.emplace_back("surface: no measurement is loaded, so it is black");
    for (const Light& light : scene.lights) {
        if (!light.on)
            notes.push_back("light '" + light.name + "': switched off");
        else if (!shines(light))
            notes.push_back("light '" + light.name + "': its intensity is 0");
        else if (model.text.usesLightSize && light.angularRadius == 0.0)
            notes.push_back("light '" + light.name +
                            "': its radius is 0, and no view direction meets a point in a mirror");
    }
    const auto hasSize = [](const Light& light) { return shines(light) && light.angularRadius > 0.0; };
    if (!model.text.usesLightSize && std::any_of(scene.lights.begin(), scene.lights.end(), hasSize))
        notes.push_back("light sizes: " + model.text.name + " sees every light as a point");
    return notes;
}

} // namespace reflectance
