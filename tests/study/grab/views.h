// Random views of the stock meshes, for the tests of what a hand does to a highlight.
#pragma once

#include "core/scene/scene.h"
#include "core/study/grab/grab.h"

#include <random>
#include <string>

namespace reflectance {

inline constexpr int viewWidth = 160, viewHeight = 120;

/// One light, and a surface that shows nothing but its highlight.
inline Scene glossyView(const std::string& mesh, LightKind kind, std::mt19937_64& random)
{
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    static const Scene fresh = defaultScene();
    Scene scene = fresh;
    scene.meshFile = mesh;
    if (!readMeshOf(scene))
        scene.mesh.reset();
    scene.camera = framed(orbited(Camera(), 3.0 * any(random), 1.2 * any(random)), 4.0 / 3.0);
    scene.camera = panned(zoomed(scene.camera, 1.0 + 0.3 * any(random)), 0.1 * any(random), 0.1 * any(random));
    scene.surface.model = "phong";
    scene.surface.values["ks"] = {1.0};
    // As narrow as it takes for the peak of the picture to be that of R.V: a point light's 1/r^2 moves it by about
    // tan(angle) / (n r), which is below a hundredth of a pixel here.
    scene.surface.values["n"] = {20000.0};
    Light light;
    light.kind = kind;
    light.direction = normalized(Vec3d(any(random), any(random), any(random)));
    light.position = 3.0 * light.direction;
    scene.lights = {light};
    return scene;
}

/// A pixel's middle on the object, away from its rim; none after some tries.
inline std::optional<ProbedPoint> anyPoint(const Scene& scene, std::mt19937_64& random)
{
    for (int attempt = 0; attempt < 200; ++attempt) {
        const double x = static_cast<double>(random() % viewWidth) + 0.5;
        const double y = static_cast<double>(random() % viewHeight) + 0.5;
        const auto point = pointAt(*scene.mesh, scene.camera, x, y, viewWidth, viewHeight);
        if (point && dot(point->N, normalized(scene.camera.eye - point->P)) > 0.25)
            return point;
    }
    return std::nullopt;
}

} // namespace reflectance
