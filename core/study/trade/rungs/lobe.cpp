#include "core/study/trade/bounds.h"
#include "core/study/trade/rungs/rungs.h"

#include <algorithm>

namespace reflectance::rung {
namespace {

/// What the form itself is off by at the lobe's most, and the rounding of a dot product in double, n times magnified.
double lobeError(const LobeFormFacts& form, double n)
{
    return form.bound(n) + (4.0 * n + 16.0) * 0x1p-53;
}

} // namespace

/// The promise is for double; float's rounding of the dot product, magnified n times, comes on top (docs/extremes.md).
Applied lobeAs(int form, Recipe& recipe)
{
    const ModelText& model = modelOf(recipe.scene).text;
    const Parameter* n = model.find("n");
    if (!model.usesLobe || !n)
        return {model.name + " has no lobe"};
    const auto wanted = static_cast<LobeForm>(form);
    const double exponent = valueOf(*n, recipe.scene.surface.values)[0];
    if (const auto possible = checkExponent(wanted, exponent); !possible)
        return {possible.error().message};
    recipe.lobe = wanted;
    Applied applied;
    const auto I = mostArriving(recipe.scene);
    if (const Parameter* ks = model.find("ks"); I && ks && (model.id == "phong" || model.id == "hybrid")) {
        const std::vector<double> strength = valueOf(*ks, recipe.scene.surface.values);
        applied.bound = std::max({strength[0] * I->x, strength[1] * I->y, strength[2] * I->z}) *
                        lobeError(factsOf(wanted), exponent);
    }
    return applied;
}

} // namespace reflectance::rung
