// Small scenes on which every rung has something to do.
#pragma once

#include "core/scene/scene.h"
#include "core/study/trade/recipe.h"

namespace reflectance::test {

/// A sphere under a strong light, a faint one and a point light, with a full K and a highlight.
[[nodiscard]] Scene shinyScene();

/// The same in each model that rungs know, a table, a mirror in the studio, and the primary convention.
[[nodiscard]] std::vector<Scene> manyScenes();

inline constexpr RenderSettings smallSettings{40, 40, 2};

} // namespace reflectance::test
