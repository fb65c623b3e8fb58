#include "core/study/trade/bounds.h"
#include "core/study/trade/rungs/matrix_rows.h"
#include "core/study/trade/rungs/rungs.h"

#include <algorithm>
#include <functional>

namespace reflectance::rung {
namespace {

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

} // namespace

/// In the scene's own convention: in the primary one this is the lecture's cheat, diag(M) I.
Applied diagonalK(int /*amount*/, Recipe& recipe)
{
    if (const std::string none = withoutK(recipe.scene); !none.empty())
        return {none};
    const Rows before = rowsOf(recipe.scene);
    const Parameter& parameter = *modelOf(recipe.scene).text.find("K");
    std::vector<double> K = valueOf(parameter, recipe.scene.surface.values);
    for (const unsigned off : {1U, 2U, 3U, 5U, 6U, 7U})
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
