#include "core/study/extremes/exhibit.h"

#include "core/geometry/load.h"
#include "core/study/extremes/directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

/// A square of 2 x 2 about the origin, with this normal.
std::shared_ptr<const Mesh> squareFacing(const Vec3d& N)
{
    const Vec3d across = tilted(N, 0.5 * std::numbers::pi, 0.0);
    const Vec3d along = cross(N, across);
    auto mesh = std::make_shared<Mesh>();
    mesh->name = "square";
    constexpr double half = 0.7; // its corners lie inside the unit sphere
    for (const auto& [a, b] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
        mesh->positions.push_back(a * across + b * along);
    mesh->normals.assign(4, N);
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh->fileVertex = {0, 1, 2, 3};
    mesh->fileVertexCount = 4;
    return mesh;
}

/// How far off its peak a lobe falls to one half, radians; 0 for a model without an exponent.
double halfWidth(const Question& question)
{
    const auto n = question.parameters.find("n");
    return n == question.parameters.end() ? 0.0 : std::sqrt(2.0 * std::numbers::ln2 / std::max(1.0, n->second.front()));
}

Scene emptyScene()
{
    Scene scene;
    scene.environment.kind = EnvironmentKind::None;
    return scene;
}

/// A sharp lobe that is looked into: its width is a tenth of the picture's height, as far as lenses go.
void lookIntoTheLobe(const Question& question, Scene& scene)
{
    scene.mesh = squareFacing(normalized(question.N));
    scene.camera.target = {};
    scene.camera.eye = 3.0 * normalized(question.V);
    scene.camera.fieldOfView = std::clamp(20.0 * halfWidth(question) * 180.0 / std::numbers::pi, 1.0, 35.0);
}

Result<void> lookAtTheSphere(const Question& question, Scene& scene)
{
    scene.meshFile = "sphere";
    if (auto read = readMeshOf(scene); !read)
        return read;
    const Vec3d N = normalized(question.N);
    const Vec3d V = normalized(question.V);
    scene.camera.target = dot(N, V) > -1e-6 ? N : Vec3d(); // a point that is turned away is not seen
    scene.camera.eye = scene.camera.target + 3.6 * V;
    return {};
}

Result<Scene> sceneOf(const Question& question)
{
    Scene scene = emptyScene();
    const double width = halfWidth(question);
    if (width > 0.0 && width < 0.1 && dot(normalized(question.N), normalized(question.V)) > 0.2)
        lookIntoTheLobe(question, scene);
    else if (auto looked = lookAtTheSphere(question, scene); !looked)
        return looked.error();
    Light light;
    light.name = "L";
    light.direction = question.L;
    light.intensity = question.I;
    light.angularRadius = question.radius;
    scene.lights = {light};
    scene.surface = {question.model, question.parameters};
    return scene;
}

/// What a camera of 35 degrees sees of a latitude-longitude picture when it looks along -z.
constexpr double seenTurns = 0.14; ///< of the width, in the picture's middle
constexpr double seenHeights = 0.18;

std::shared_ptr<const Image> surroundingsOf(const std::function<double(double x, double y)>& value)
{
    auto map = std::make_shared<Image>(2048, 1024);
    for (int row = 0; row < map->height; ++row)
        for (int column = 0; column < map->width; ++column) {
            const double x = ((column + 0.5) / map->width - 0.5) / seenTurns + 0.5;
            const double y = ((row + 0.5) / map->height - 0.5) / seenHeights + 0.5;
            const bool inside = x >= 0.0 && x < 1.0 && y >= 0.0 && y < 1.0;
            std::fill_n(map->at(column, row), 3, inside ? static_cast<float>(value(x, y)) : 0.0F);
        }
    return map;
}

} // namespace

Show unseen(std::string why)
{
    return [why = std::move(why)] { return Exhibit{std::nullopt, why}; };
}

Show seenScene(std::function<Result<Scene>()> make, std::string caption)
{
    return [make = std::move(make), caption = std::move(caption)] {
        Result<Scene> scene = make();
        return scene ? Exhibit{*std::move(scene), caption} : Exhibit{std::nullopt, scene.error().sentence()};
    };
}

Show seen(Question question, std::string caption)
{
    return seenScene([question = std::move(question)] { return sceneOf(question); }, std::move(caption));
}

Show seenMesh(std::string objText, std::string caption)
{
    return seenScene([objText = std::move(objText)] { return sceneOfObj(objText); }, std::move(caption));
}

Show seenRadiance(std::function<double(double x, double y)> value, std::string caption)
{
    return seenScene(
        [value = std::move(value)]() -> Result<Scene> {
            Scene scene = emptyScene();
            auto nothing = std::make_shared<Mesh>();
            nothing->name = "ramp";
            scene.mesh = nothing;
            scene.camera = {.eye = {0, 0, 3}};
            scene.environment.kind = EnvironmentKind::Map;
            scene.environment.map = surroundingsOf(value);
            scene.background.kind = BackgroundKind::Environment;
            return scene;
        },
        std::move(caption));
}

Result<Scene> sceneOfObj(const std::string& objText)
{
    auto read = readMesh(objText, "extreme.obj");
    if (!read)
        return read.error();
    Scene scene = emptyScene();
    scene.mesh = read->mesh;
    scene.background.color = {};
    scene.lights.emplace_back();
    scene.lights.front().direction = {-0.5, 0.7, 0.8};
    return scene;
}

} // namespace reflectance
