#include "core/scene/requirements.h"
#include "core/study/trade/rungs/rungs.h"

namespace reflectance::rung {

/// The way back from leaving out what is 0: dearer, and equal but for rounding where a diagonal K or one ks re-associates.
Applied generalPath(int /*amount*/, Recipe& recipe)
{
    if (requiredSurface(recipe.scene, recipe.arithmetic()).leftOut.empty())
        return {"the scene requires all of " + modelOf(recipe.scene).text.name};
    recipe.specialised = false;
    return {};
}

} // namespace reflectance::rung
