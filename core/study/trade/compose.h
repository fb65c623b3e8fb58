// Which recipes are tried: every rung alone, then combinations that the single ones suggest.
#pragma once

#include "core/study/trade/trade.h"

namespace reflectance {

/// The scene as the renderers' arithmetics draw it without any other rung: SIMD, float, double; GLSL, also into a half buffer.
[[nodiscard]] std::vector<Recipe> bareRecipes(const Scene& scene, const RenderSettings& settings, bool withGl);

/// Each rung alone in SIMD and, with GL, in GLSL. Rungs that apply nowhere are noted in `skipped`.
struct Singles {
    std::vector<Recipe> recipes;
    std::vector<std::optional<double>> bounds; ///< of each recipe's rung
    std::vector<SkippedRung> skipped;
};
[[nodiscard]] Singles singleRungs(const std::vector<Recipe>& bare);

/// Not the full product, which would be thousands. For each renderer, each number of samples that was tried, and each level
/// of change: of every other axis the cheapest rung whose own change (of RMSE where that is the metric, else the largest) is
/// within the level, if it is cheaper than none. Levels are changes that single rungs made, each at least three times the one
/// before. No recipe twice.
[[nodiscard]] std::vector<Recipe> compositions(const std::vector<Recipe>& bare, const std::vector<Candidate>& singles,
                                               Metric metric, Cost cost);

} // namespace reflectance
