#include "core/study/trade/bounds.h"
#include "core/study/trade/rungs/rungs.h"

namespace reflectance::rung {

Applied inPrecision(int precision, Recipe& recipe)
{
    recipe.precision = static_cast<Precision>(precision);
    return {};
}

/// A stored channel is off by at most 2^-10 of itself, whichever way the driver rounds, or by 2^-24 where it is subnormal.
/// The background is stored as well.
Applied halfBuffer(int /*amount*/, Recipe& recipe)
{
    if (!recipe.onGl())
        return {"only the GL renderer keeps the linear picture in a buffer of its own"};
    recipe.halfBuffer = true;
    Applied applied;
    const auto brightest = largestRadiance(recipe.scene);
    const Vec3d& behind = recipe.scene.background.color;
    if (brightest && recipe.scene.background.kind == BackgroundKind::Plain &&
        !modelOf(recipe.scene).text.usesEnvironment)
        applied.bound = 0x1p-10 * std::max({*brightest, behind.x, behind.y, behind.z}) + 0x1p-24;
    return applied;
}

} // namespace reflectance::rung
