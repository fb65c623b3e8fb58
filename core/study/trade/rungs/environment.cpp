#include "core/illumination/even_directions.h"
#include "core/illumination/harmonics.h"
#include "core/study/trade/rungs/rungs.h"

namespace reflectance::rung {
namespace {

std::string unseen(const Scene& scene)
{
    if (scene.environment.kind == EnvironmentKind::None)
        return "nothing surrounds the object";
    const bool behind = scene.background.kind == BackgroundKind::Environment;
    if (!modelOf(scene).text.usesEnvironment && !behind)
        return modelOf(scene).text.name + " does not look at the surroundings, nor is the background made of them";
    return "";
}

} // namespace

/// The mean radiance over all directions, on a Fibonacci sphere.
Applied oneColourAround(int /*amount*/, Recipe& recipe)
{
    if (const std::string why = unseen(recipe.scene); !why.empty())
        return {why};
    if (recipe.scene.environment.kind == EnvironmentKind::Constant)
        return {"the surroundings are one colour already"};
    constexpr int directions = 20000;
    Vec3d sum;
    for (int i = 0; i < directions; ++i)
        sum += radianceFrom(recipe.scene.environment, evenDirection(i, directions));
    Environment flat;
    flat.kind = EnvironmentKind::Constant;
    flat.radiance = sum / static_cast<double>(directions);
    recipe.scene.environment = flat;
    return {};
}

/// Spherical harmonics up to the second order in the surroundings' place.
Applied nineCoefficients(int /*amount*/, Recipe& recipe)
{
    if (const std::string why = unseen(recipe.scene); !why.empty())
        return {why};
    if (recipe.scene.environment.kind == EnvironmentKind::Constant)
        return {"the surroundings are one colour already"};
    const Environment around = recipe.scene.environment;
    recipe.scene.environment =
        environmentOf(projected([&around](const Vec3d& direction) { return radianceFrom(around, direction); }));
    return {};
}

/// Means over blocks of factor x factor texels.
Applied coarseSurroundings(int factor, Recipe& recipe)
{
    if (const std::string why = unseen(recipe.scene); !why.empty())
        return {why};
    const auto& map = recipe.scene.environment.map;
    if (recipe.scene.environment.kind != EnvironmentKind::Map || !map)
        return {"the surroundings are no picture"};
    const int width = map->width / factor;
    const int height = map->height / factor;
    if (width < 2 || height < 2 || width * factor != map->width || height * factor != map->height)
        return {"the surroundings' picture cannot be divided into blocks of " + std::to_string(factor) + " texels"};
    auto coarse = std::make_shared<Image>(width, height);
    for (int y = 0; y < height * factor; ++y)
        for (int x = 0; x < width * factor; ++x)
            for (int channel = 0; channel < 3; ++channel)
                coarse->at(x / factor, y / factor)[channel] +=
                    map->at(x, y)[channel] / static_cast<float>(factor * factor);
    recipe.scene.environment.map = std::move(coarse);
    return {};
}

} // namespace reflectance::rung
