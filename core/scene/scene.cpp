#include "core/scene/scene.h"

#include "core/geometry/load.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <span>

namespace reflectance {

Scene defaultScene()
{
    Scene scene;
    scene.meshFile = "mug";
    if (const auto read = readMeshOf(scene); !read) { // cannot happen: the mesh is part of the program
        std::cerr << read.error().sentence() << '\n';
        std::abort();
    }
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

namespace {

Mat3d matrixOf(std::span<const double> rowByRow)
{
    const auto& n = rowByRow;
    return {{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}}};
}

} // namespace

const Model& modelOf(const Scene& scene)
{
    const auto model = findModel(scene.surface.model);
    return model ? **model : catalogue().front();
}

std::vector<double> valuesOf(const Scene& scene)
{
    const ModelText& text = modelOf(scene).text;
    std::vector<double> values = flatValues(text, scene.surface.values);
    if (scene.surface.convention == Convention::Sensor)
        return values;
    const Mat3d fromSeen = inverse(matrixOf(scene.surface.W));
    for (const Parameter& parameter : text.parameters) {
        if (parameter.kind != ParameterKind::Matrix)
            continue;
        const std::span<double> K = std::span(values).subspan(parameter.offset, 9);
        const auto inSensorConvention = rowByRow(matrixOf(K) * fromSeen);
        std::copy(inSensorConvention.begin(), inSensorConvention.end(), K.begin());
    }
    return values;
}

std::vector<Light> shiningLights(const Scene& scene)
{
    std::vector<Light> lights;
    std::copy_if(scene.lights.begin(), scene.lights.end(), std::back_inserter(lights),
                 [](const Light& l) { return l.on; });
    if (scene.surface.convention == Convention::Primary)
        for (Light& light : lights)
            light.intensity = matrixOf(scene.surface.W) * light.intensity;
    return lights;
}

Result<void> readMeshOf(Scene& scene)
{
    LoadOptions options;
    options.recomputeNormals = scene.recomputeNormals;
    auto loaded = loadStockOrFile(scene.meshFile, options);
    if (!loaded)
        return loaded.error();
    scene.mesh = std::move(loaded->mesh);
    return {};
}

} // namespace reflectance
