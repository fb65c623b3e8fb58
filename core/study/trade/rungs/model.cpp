#include "core/reflectance/evaluate.h"
#include "core/study/trade/bounds.h"
#include "core/study/trade/rungs/rungs.h"

#include <algorithm>
#include <initializer_list>

namespace reflectance::rung {
namespace {

bool isOneOf(const Scene& scene, std::initializer_list<const char*> models)
{
    return std::any_of(models.begin(), models.end(), [&](const char* id) { return modelOf(scene).id() == id; });
}

std::string itsWord(const Scene& scene, const char* what)
{
    return modelOf(scene).text.name + " " + what;
}

/// What the surface makes of white light with N = L = V.
Vec3d straightOn(const Surface& surface)
{
    const Model& model = modelOf(surface);
    const Observation row{{0, 0, 1}, {0, 0, 1}, {{{0, 0, 1}, {1, 1, 1}}}};
    return evaluate(model, flatValues(model.text, surface.values), {&row, 1}, Precision::Double)[0];
}

std::vector<double> numbers(const Surface& surface, const char* name)
{
    const Parameter* parameter = modelOf(surface).text.find(name);
    return valueOf(*parameter, surface.values);
}

double share(double wanted, double found)
{
    return found > 0.0 ? wanted / found : 1.0;
}

/// The albedo with which `to` is as bright as `from` seen from the light: found step by step, since interreflection makes
/// colours depend on the albedo's square.
void matchAlbedo(const Surface& from, Surface& to)
{
    const Vec3d wanted = straightOn(from);
    std::vector<double> rho = numbers(to, "rho");
    for (int step = 0; step < 6; ++step) {
        const Vec3d found = straightOn(to);
        rho = {std::clamp(rho[0] * share(wanted.x, found.x), 0.0, 1.0),
               std::clamp(rho[1] * share(wanted.y, found.y), 0.0, 1.0),
               std::clamp(rho[2] * share(wanted.z, found.z), 0.0, 1.0)};
        to.values["rho"] = rho;
    }
}

} // namespace

/// Phong's lobe is at most 1, so what is left out is at most ks I.
Applied withoutHighlight(int /*amount*/, Recipe& recipe)
{
    if (!isOneOf(recipe.scene, {"hybrid"}))
        return {itsWord(recipe.scene, "has no specular term beside its diffuse one")};
    Applied applied;
    if (const auto I = mostArriving(recipe.scene)) {
        const std::vector<double> ks = numbers(recipe.scene.surface, "ks");
        applied.bound = std::max({ks[0] * I->x, ks[1] * I->y, ks[2] * I->z});
    }
    recipe.scene.surface.model = "lambert_color";
    return applied;
}

Applied qualitativeOrenNayar(int /*amount*/, Recipe& recipe)
{
    if (!isOneOf(recipe.scene, {"oren_nayar_full"}))
        return {itsWord(recipe.scene, "has no long form to give up")};
    const Surface before = recipe.scene.surface;
    recipe.scene.surface.model = "oren_nayar";
    matchAlbedo(before, recipe.scene.surface);
    return {};
}

/// EON's r takes the place of Oren-Nayar's B / A: both weigh s / t against a constant.
Applied energyPreserving(int polynomial, Recipe& recipe)
{
    const char* target = polynomial != 0 ? "eon_polynomial" : "eon";
    const bool fromOrenNayar = isOneOf(recipe.scene, {"oren_nayar", "oren_nayar_full"});
    if (!fromOrenNayar && !(polynomial != 0 && isOneOf(recipe.scene, {"eon"})))
        return {itsWord(recipe.scene, "is no Oren-Nayar surface")};
    const Surface before = recipe.scene.surface;
    recipe.scene.surface.model = target;
    if (!fromOrenNayar)
        return {};
    const double sigma = numbers(before, "sigma")[0];
    const double variance = std::min(sigma, 1e9) * std::min(sigma, 1e9);
    const double A = 1.0 - 0.5 * variance / (variance + 0.33);
    const double B = 0.45 * variance / (variance + 0.09);
    recipe.scene.surface.values["r"] = {std::clamp(B / A, 0.0, 1.0)};
    std::vector<double> rho = numbers(before, "rho");
    for (double& channel : rho)
        channel = std::clamp(channel, 0.0, 1.0);
    recipe.scene.surface.values["rho"] = rho;
    matchAlbedo(before, recipe.scene.surface);
    return {};
}

/// A diagonal K as bright as the rough surface seen from the light.
Applied smoothMatte(int /*amount*/, Recipe& recipe)
{
    if (!isOneOf(recipe.scene, {"oren_nayar", "oren_nayar_full", "oren_nayar_fujii", "eon", "eon_polynomial"}))
        return {itsWord(recipe.scene, "is no rough matte surface")};
    const Vec3d k = straightOn(recipe.scene.surface);
    recipe.scene.surface.model = "lambert_color";
    recipe.scene.surface.values["K"] = {k.x, 0, 0, 0, k.y, 0, 0, 0, k.z};
    return {};
}

} // namespace reflectance::rung
