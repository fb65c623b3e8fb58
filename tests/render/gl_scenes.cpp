#include "tests/render/gl_scenes.h"

#include "tests/render/sphere.h"

#include <algorithm>

namespace reflectance::test {

std::shared_ptr<const Mesh> square()
{
    auto mesh = std::make_shared<Mesh>();
    mesh->name = "square";
    mesh->positions = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
    mesh->normals.assign(4, {0, 0, 1});
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

Scene twoLightScene(const std::string& model, int rings)
{
    Scene scene;
    scene.mesh = sphereMesh(rings);
    scene.surface.model = model;
    Light key;
    key.direction = {-0.5, 0.7, 0.8};
    key.intensity = {1.0, 0.8, 0.5};
    Light lamp;
    lamp.kind = LightKind::Point;
    lamp.position = {1.6, -0.4, 1.1};
    lamp.intensity = {0.3, 0.6, 0.9};
    scene.lights = {key, lamp};
    scene.environment.kind = EnvironmentKind::None;
    return scene;
}

std::shared_ptr<const Image> colorfulMap()
{
    auto image = std::make_shared<Image>(64, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            float* rgb = image->at(x, y);
            rgb[0] = 0.02F * static_cast<float>(x);
            rgb[1] = 0.05F * static_cast<float>(y);
            rgb[2] = static_cast<float>((x * 7 + y * 3) % 11) / 11.0F;
        }
    return image;
}

double brightest(const Scene& scene)
{
    double sum = 0.0;
    for (const Light& light : shiningLights(scene)) {
        const double distance = length(light.position) - 1.0; // of the sphere's nearest point
        const double falloff = light.kind == LightKind::Point ? 1.0 / (distance * distance) : 1.0;
        sum += falloff * std::max({light.intensity.x, light.intensity.y, light.intensity.z});
    }
    return sum;
}

} // namespace reflectance::test
