// What the flags of `render` ask for, and a saved picture's recipe in the same words.
#pragma once

#include "app/cli/scene_options.h"
#include "core/render/pictures/render_picture.h"
#include "core/scene/kept_picture.h"

#include <string>

namespace reflectance::cli {

struct RenderOptions {
    SceneOptions scene;
    std::string out;
    std::string backend = "auto";
    std::string precision;
    std::string context = "any";
    std::string shading;
    std::string lens;
    std::string highlightAt; ///< "X,Y" or "X,Y,LIGHT"; empty: the lights stay
    std::string edgeAt;      ///< the same; empty: the highlight's width stays
    std::string probe;       ///< "X,Y" in pixels; empty: none
    std::string lobe;        ///< empty: conditioned, or as a saved picture has
    std::string variant; ///< "A", "B", "side", "wipe", "difference" or a kept name; empty: A, or as a saved picture has
    std::string variantA, variantB; ///< names of kept surfaces; empty: as the scene has them
    double divider = 0.5;
    std::string term;     ///< seen alone: see onlyTerm; "all": the whole; empty: the whole, or as a saved picture has
    bool general = false; ///< nothing is specialised: terms that are 0 are computed too
    bool noCache = false; ///< nothing is read from or written to the user's cache folder
    int frames = 1;
    std::string reference;
    double threshold = 0.0;
    std::string json;
    bool waterfall = false;
    std::string truth; ///< a scene file; empty: the scene itself
};

[[nodiscard]] Result<RenderPlan> planFrom(const RenderOptions& options);

/// What no flag says, as the picture was made.
[[nodiscard]] RenderOptions completed(RenderOptions options, const PictureRecipe& recipe);

/// How to make the picture again. `rendered` tells backend and precision.
[[nodiscard]] PictureRecipe recipeFrom(const RenderOptions& options, const RenderSettings& settings,
                                       const std::string& backend, const std::string& precision);

} // namespace reflectance::cli
