#include "core/study/trade/bounds.h"
#include "core/study/trade/rungs/matrix_rows.h"
#include "core/study/trade/rungs/rungs.h"

#include <cmath>

namespace reflectance::rung {
namespace {

double brightest(const Vec3d& I)
{
    return std::max({I.x, I.y, I.z});
}

/// The colour that all lights share, its largest component 1; black where they do not share one.
Vec3d sharedColour(const std::vector<Light>& lights)
{
    const Vec3d first = lights.front().intensity;
    if (!(brightest(first) > 0.0))
        return {};
    for (const Light& light : lights) {
        const Vec3d apart = cross(first, light.intensity);
        // Parallel but for the rounding of numbers that were multiplied by one factor.
        if (length(apart) > 4.0 * 0x1p-53 * length(first) * length(light.intensity))
            return {};
    }
    return first / brightest(first);
}

} // namespace

/// Lights s_i C: the sum of cosine_i K s_i C is that of cosine_i s_i times K C, which is formed once, before any light; ks
/// takes the lights' colour alike. Equal in real numbers. Rounding: what K I takes (5 roundings and 2 of its factors), against
/// one product of one rounded number, and the sum over the lights in both.
Applied oneLightColour(int /*amount*/, Recipe& recipe)
{
    if (const std::string none = withoutK(recipe.scene); !none.empty())
        return {none};
    const Rows K = rowsOf(recipe.scene);
    if (isDiagonal(K))
        return {"K is diagonal, so that there is nothing to gain"};
    const auto most = largestRadiance(recipe.scene);
    const std::vector<Light> lights = shiningLights(recipe.scene);
    if (lights.empty())
        return {"no light shines"};
    const Vec3d C = sharedColour(lights);
    if (C == Vec3d())
        return {"the lights have different colours"};
    const ModelText& text = modelOf(recipe.scene).text;
    turnToSensorConvention(recipe.scene);
    Scene& scene = recipe.scene;
    scene.lights = lights;
    for (Light& light : scene.lights)
        light.intensity = Vec3d(brightest(light.intensity));
    const auto folded = [&](std::size_t row) { return K[row] * C.x + K[row + 1] * C.y + K[row + 2] * C.z; };
    scene.surface.values["K"] = {folded(0), 0, 0, 0, folded(3), 0, 0, 0, folded(6)};
    if (const Parameter* height = text.find("ks")) {
        const std::vector<double> ks = valueOf(*height, scene.surface.values);
        scene.surface.values["ks"] = {ks[0] * C.x, ks[1] * C.y, ks[2] * C.z};
    }
    Applied applied;
    const double roundoff = recipe.precision == Precision::Double ? 0x1p-53 : 0x1p-24;
    if (most)
        applied.bound = (16.0 + 2.0 * static_cast<double>(lights.size())) * roundoff * *most;
    return applied;
}

} // namespace reflectance::rung
