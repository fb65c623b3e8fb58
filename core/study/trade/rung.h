// A rung: one named change that makes a picture cheaper or better. A rung is a value in rungs.cpp and a function in rungs/.
#pragma once

#include "core/study/trade/recipe.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace reflectance {

/// What a rung trades. Two rungs of one axis exclude each other.
enum class RungAxis {
    Precision,
    Matrix,
    Lobe,
    Requirements,
    Model,
    Place,
    Samples,
    Resolution,
    Table,
    Lights,
    LightColour,
    Environment
};

[[nodiscard]] constexpr std::string_view nameOf(RungAxis axis)
{
    constexpr std::string_view names[] = {"precision", "colour matrix", "lobe",         "requirements",
                                          "model",     "shading place", "samples",      "resolution",
                                          "table",     "lights",        "light colour", "environment"};
    return names[static_cast<int>(axis)];
}

/// What became of a rung that was to change a recipe.
struct Applied {
    std::string skipped = {}; ///< why it does not apply, as a clause: "K is diagonal already"; the recipe then stays
    /// The largest linear difference to the recipe before, in any channel of any pixel, where the rung promises one. It is
    /// proven from the scene, not measured.
    std::optional<double> bound = {};
};

struct Rung {
    const char* id; ///< "k_diagonal"
    RungAxis axis;
    const char* about; ///< what is given up or gained, as a clause: "the off-diagonal entries of K"
    bool onCpu, onGl;  ///< which renderers have it
    Applied (*apply)(int amount, Recipe& recipe);
    int amount = 0; ///< for rungs that differ in a number only
};

/// All rungs, by axis.
[[nodiscard]] std::span<const Rung> rungs();

[[nodiscard]] const Rung* findRung(std::string_view id);

/// Changes the recipe, notes the rung's id in it, and refuses what the recipe's renderer does not have.
[[nodiscard]] Applied applyRung(const Rung& rung, Recipe& recipe);

} // namespace reflectance
