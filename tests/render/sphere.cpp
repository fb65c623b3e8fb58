#include "tests/render/sphere.h"

#include <cmath>
#include <numbers>

namespace reflectance::test {

std::shared_ptr<const Mesh> sphereMesh(int rings)
{
    auto mesh = std::make_shared<Mesh>();
    mesh->name = "sphere";
    const int around = 2 * rings;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j <= around; ++j) {
            const double polar = std::numbers::pi * i / rings;
            const double azimuth = 2.0 * std::numbers::pi * j / around;
            const Vec3d p{std::sin(polar) * std::cos(azimuth), std::cos(polar), -std::sin(polar) * std::sin(azimuth)};
            mesh->positions.push_back(p);
            mesh->normals.push_back(normalized(p));
        }
    const auto vertex = [around](int i, int j) { return static_cast<std::uint32_t>(i * (around + 1) + j); };
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < around; ++j) {
            if (i > 0)
                mesh->triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
            if (i + 1 < rings)
                mesh->triangles.push_back({vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)});
        }
    return mesh;
}

Scene sphereScene(const std::string& model, int rings)
{
    Scene scene;
    scene.mesh = sphereMesh(rings);
    scene.camera.eye = {0.0, 0.0, 4.0};
    scene.camera.fieldOfView = 32.0;
    Light light;
    light.direction = {1.0, 1.0, 1.0};
    scene.lights = {light};
    scene.environment.kind = EnvironmentKind::None;
    scene.background.color = {0.0, 0.0, 0.0};
    scene.surface.model = model;
    return scene;
}

} // namespace reflectance::test
