// A rung: one named change that makes a picture cheaper or better. A rung is a
// line in core/scene/rung_list.h, one in rungs.cpp and a function in rungs/.
#pragma once

#include "core/scene/rung_list.h"
#include "core/study/trade/recipe.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace reflectance {

/// What became of a rung that was to change a recipe.
struct Applied {
    std::string skipped = {}; ///< why it does not apply, as a clause: "K is diagonal already"; the recipe then stays
    /// The largest linear difference to the recipe before, in any channel of any pixel, where the rung promises one. It is
    /// proven from the scene, not measured.
    std::optional<double> bound = {};
};

struct SkippedRung {
    std::string rung, why;
};

struct Rung : RungFacts {
    Applied (*apply)(int amount, Recipe& recipe);
    int amount = 0; ///< for rungs that differ in a number only
};

/// All rungs, in the order of rungList.
[[nodiscard]] std::span<const Rung> rungs();

[[nodiscard]] const Rung* findRung(std::string_view id);

/// Changes the recipe, notes the rung's id in it, and refuses what the recipe's renderer does not have.
[[nodiscard]] Applied applyRung(const Rung& rung, Recipe& recipe);

/// A recipe with the rungs that its scene's surface names, and which of them change nothing here.
struct WithRungs {
    Recipe recipe;
    std::vector<SkippedRung> withoutEffect = {};
};

/// Applies scene.surface.rungs. A precision that they name counts; else the recipe's own, unless a rung belongs to the other
/// renderer: GLSL there, SIMD here. Refuses what checkRungs refuses.
[[nodiscard]] Result<WithRungs> withItsRungs(Recipe recipe);

} // namespace reflectance
