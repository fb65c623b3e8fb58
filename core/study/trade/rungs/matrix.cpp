#include "core/study/trade/bounds.h"
#include "core/study/trade/rungs/rungs.h"

#include <algorithm>
#include <functional>

namespace reflectance::rung {
namespace {

using Rows = std::array<double, 9>;

Rows rowsOf(const Scene& scene)
{
    Rows K{};
    const Parameter& parameter = *modelOf(scene).text.find("K");
    std::copy_n(valuesOf(scene).begin() + static_cast<std::ptrdiff_t>(parameter.offset), 9, K.begin());
    return K;
}

/// The same picture with K and lights in the sensor convention.
void turnToSensorConvention(Scene& scene)
{
    if (scene.surface.convention == Convention::Sensor)
        return;
    const Rows K = rowsOf(scene);
    scene.lights = shiningLights(scene);
    scene.surface.convention = Convention::Sensor;
    scene.surface.values["K"].assign(K.begin(), K.end());
}

bool isDiagonal(const Rows& K)
{
    return K[1] == 0.0 && K[2] == 0.0 && K[3] == 0.0 && K[5] == 0.0 && K[6] == 0.0 && K[7] == 0.0;
}

bool isGrey(const Rows& K)
{
    return isDiagonal(K) && K[0] == K[4] && K[4] == K[8];
}

/// What K changed by, times the most light that arrives: cosines are at most 1.
Applied changedBy(const Rows& before, const Recipe& recipe)
{
    Rows change = rowsOf(recipe.scene);
    std::transform(change.begin(), change.end(), before.begin(), change.begin(), std::minus<>());
    Applied applied;
    if (const auto I = mostArriving(recipe.scene))
        applied.bound = largestOf(change, *I);
    return applied;
}

/// Why a scene has no K to simplify; empty where it has.
std::string withoutK(const Scene& scene)
{
    const ModelText& text = modelOf(scene).text;
    const Parameter* K = text.find("K");
    return K && K->kind == ParameterKind::Matrix ? "" : text.name + " has no K";
}

} // namespace

/// In the scene's own convention: in the primary one this is the lecture's cheat, diag(M) I.
Applied diagonalK(int /*amount*/, Recipe& recipe)
{
    if (const std::string none = withoutK(recipe.scene); !none.empty())
        return {none};
    const Rows before = rowsOf(recipe.scene);
    const Parameter& parameter = *modelOf(recipe.scene).text.find("K");
    std::vector<double> K = valueOf(parameter, recipe.scene.surface.values);
    for (const std::size_t off : {1, 2, 3, 5, 6, 7})
        K[off] = 0.0;
    if (K == valueOf(parameter, recipe.scene.surface.values))
        return {"K is diagonal already"};
    recipe.scene.surface.values["K"] = std::move(K);
    return changedBy(before, recipe);
}

/// k_i = sum over j of K_ij in the sensor convention: right under white light, as a single albedo colour is.
Applied colourUnderWhite(int /*amount*/, Recipe& recipe)
{
    if (const std::string none = withoutK(recipe.scene); !none.empty())
        return {none};
    const Rows before = rowsOf(recipe.scene);
    if (isDiagonal(before))
        return {"K is diagonal already"};
    turnToSensorConvention(recipe.scene);
    const Rows& K = before;
    recipe.scene.surface.values["K"] = {K[0] + K[1] + K[2], 0, 0, 0, K[3] + K[4] + K[5], 0, 0, 0, K[6] + K[7] + K[8]};
    return changedBy(before, recipe);
}

/// The mean of the colour under white light, for all three channels.
Applied greyK(int /*amount*/, Recipe& recipe)
{
    if (const std::string none = withoutK(recipe.scene); !none.empty())
        return {none};
    const Rows before = rowsOf(recipe.scene);
    if (isGrey(before))
        return {"K is grey already"};
    turnToSensorConvention(recipe.scene);
    double sum = 0.0;
    for (const double entry : before)
        sum += entry;
    const double k = sum / 3.0;
    recipe.scene.surface.values["K"] = {k, 0, 0, 0, k, 0, 0, 0, k};
    return changedBy(before, recipe);
}

} // namespace reflectance::rung
