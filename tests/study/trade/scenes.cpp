#include "tests/study/trade/scenes.h"

#include "core/study/tables/sample_model.h"
#include "tests/render/sphere.h"

namespace reflectance::test {

Scene shinyScene()
{
    Scene scene = sphereScene("hybrid", 24);
    scene.surface.values = {{"ks", {0.4, 0.3, 0.2}}, {"n", {30.5}}};
    scene.lights[0].intensity = {0.9, 0.7, 0.5};
    Light faint;
    faint.name = "faint";
    faint.direction = {-1.0, 0.4, 1.0};
    faint.intensity = Vec3d(0.0004, 0.0005, 0.0006);
    Light lamp;
    lamp.name = "lamp";
    lamp.kind = LightKind::Point;
    lamp.position = {-2.0, 1.5, 2.5};
    lamp.intensity = Vec3d(1.5);
    scene.lights.push_back(faint);
    scene.lights.push_back(lamp);
    return scene;
}

std::vector<Scene> manyScenes()
{
    std::vector<Scene> scenes;
    for (const char* model :
         {"hybrid", "lambert", "lambert_color", "phong", "oren_nayar", "oren_nayar_full", "eon", "ggx"}) {
        scenes.push_back(shinyScene());
        scenes.back().surface.model = model;
    }
    Scene primary = shinyScene();
    primary.surface.convention = Convention::Primary;
    primary.surface.W = {0.8, 0.15, 0.05, 0.2, 0.6, 0.2, 0.05, 0.15, 0.8};
    scenes.push_back(primary);
    Scene alike = shinyScene();
    for (Light& light : alike.lights)
        light.intensity = light.intensity.x * Vec3d(1.0, 0.75, 0.5);
    scenes.push_back(alike);
    Scene table = shinyScene();
    table.surface.model = "table";
    const Model& rough = **findModel("oren_nayar");
    table.surface.table = measuredTable(
        sampledModel(rough, flatValues(rough.text, {}), isotropicShape(13, 9), Interpolation::MonotoneCubic, 3).table);
    scenes.push_back(table);
    Scene mirror = shinyScene();
    mirror.surface.model = "mirror";
    mirror.environment.kind = EnvironmentKind::Studio;
    scenes.push_back(mirror);
    return scenes;
}

} // namespace reflectance::test
