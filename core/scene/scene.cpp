#include "core/scene/scene.h"

#include "core/base/embedded.h"
#include "core/geometry/load.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>

namespace reflectance {

Scene defaultScene()
{
    Scene scene;
    scene.meshFile = "mug";
    auto mesh = openMesh(scene.meshFile);
    if (!mesh) { // cannot happen: the mesh is part of the program
        std::cerr << mesh.error().sentence() << '\n';
        std::abort();
    }
    scene.mesh = *std::move(mesh);
    scene.camera = framed(scene.camera, 1.0);
    Light key;
    key.name = "key";
    key.direction = normalized(Vec3d(-0.25, 0.6, 0.75));
    key.intensity = Vec3d(1.0, 0.97, 0.92);
    key.angularRadius = 4.0;
    Light fill;
    fill.name = "fill";
    fill.direction = normalized(Vec3d(0.9, 0.15, 0.35));
    fill.intensity = Vec3d(0.16, 0.19, 0.24);
    fill.angularRadius = 8.0;
    scene.lights = {key, fill};
    return scene;
}

const Model& modelOf(const Scene& scene)
{
    const auto model = findModel(scene.surface.model);
    return model ? **model : catalogue().front();
}

std::vector<double> valuesOf(const Scene& scene)
{
    return flatValues(modelOf(scene).text, scene.surface.values);
}

std::vector<Light> shiningLights(const Scene& scene)
{
    std::vector<Light> lights;
    std::copy_if(scene.lights.begin(), scene.lights.end(), std::back_inserter(lights), [](const Light& l) { return l.on; });
    return lights;
}

std::vector<std::string> stockMeshes()
{
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embeddedFiles())
        if (file.name.starts_with("meshes/") && file.name.ends_with(".obj"))
            names.emplace_back(file.name.substr(7, file.name.size() - 11));
    return names;
}

Result<std::shared_ptr<const Mesh>> openMesh(const std::string& nameOrPath)
{
    for (const EmbeddedFile& file : embeddedFiles()) {
        if (file.name != "meshes/" + nameOrPath + ".obj")
            continue;
        auto loaded = readMesh(file.bytes, nameOrPath, LoadOptions{});
        if (!loaded)
            return loaded.error();
        return loaded->mesh;
    }
    auto loaded = loadMesh(nameOrPath, LoadOptions{});
    if (!loaded)
        return loaded.error();
    return loaded->mesh;
}

} // namespace reflectance
