#include "core/study/trade/recipe.h"

#include "core/base/text.h"

#include <algorithm>

namespace reflectance {

RenderSettings drawnSettings(const Recipe& recipe)
{
    const auto reduced = [&](int size) { return std::max(1, (size + recipe.reduction - 1) / recipe.reduction); };
    return {reduced(recipe.settings.width), reduced(recipe.settings.height), recipe.settings.samplesPerAxis};
}

std::string nameOf(const Recipe& recipe)
{
    return recipe.rungs.empty() ? "as it is" : joined(recipe.rungs, " + ");
}

} // namespace reflectance
