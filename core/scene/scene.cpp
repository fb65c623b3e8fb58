#include "core/scene/scene.h"

#include "core/base/text.h"
#include "core/geometry/load.h"
#include "core/reflectance/lists.h"
#include "core/reflectance/own_model.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <span>
#include <utility>

namespace reflectance {
namespace {

Scene madeDefaultScene()
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

} // namespace

/// Made once: every scene file begins with a copy, and copies share the mesh.
Scene defaultScene()
{
    static const Scene scene = madeDefaultScene();
    return scene;
}

namespace {

Mat3d matrixOf(std::span<const double> rowByRow)
{
    const auto& n = rowByRow;
    return {{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}}};
}

} // namespace

Result<const Model*> findModelOf(const Surface& surface)
{
    if (surface.own && surface.own->id() == surface.model)
        return surface.own.get();
    return findModel(surface.model);
}

Result<void> readModelOf(Surface& surface, const std::string& path)
{
    auto model = readOwnModel(path);
    if (!model)
        return model.error();
    surface.own = *std::move(model);
    surface.model = surface.own->id();
    surface.modelFile = path;
    return {};
}

const Model& modelOf(const Surface& surface)
{
    const auto model = findModelOf(surface);
    return model ? **model : catalogue().front();
}

Scene variantB(Scene scene)
{
    if (scene.other)
        scene.surface = *std::move(scene.other);
    scene.other.reset();
    return scene;
}

const Model& modelOf(const Scene& scene)
{
    return modelOf(scene.surface);
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

Result<void> readTableOf(Surface& surface, const std::string& path)
{
    auto table = loadTable(path);
    if (!table)
        return table.error();
    surface.table = *std::move(table);
    surface.tableFile = path;
    return {};
}

Result<void> setOnSurface(std::string_view assignment, Surface& surface)
{
    const auto model = findModelOf(surface);
    if (!model)
        return model.error();
    const std::size_t equals = std::min(assignment.find('='), assignment.size());
    if (!(*model)->text.usesTable || trimmed(assignment.substr(0, equals)) != "file")
        return setParameter((*model)->text, assignment, surface.values);
    return readTableOf(surface, std::string(trimmed(assignment.substr(std::min(equals + 1, assignment.size())))));
}

Result<void> checkSurface(const Surface& surface)
{
    const auto model = findModelOf(surface);
    if (!model)
        return model.error();
    if ((*model)->text.usesTable && !surface.table)
        return Error{"the model " + surface.model + " needs a measurement; name its file: file=PATH"};
    return checkLists((*model)->text, surface.values);
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
