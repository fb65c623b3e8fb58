// Term bars: what each term of a picture buys, and what it costs.
#pragma once

#include "core/render/progress.h"
#include "core/study/cost/timing.h"
#include "core/study/trade/judge.h"
#include "core/study/trade/recipe.h"

#include <optional>
#include <string>
#include <vector>

namespace reflectance {

/// A scene without one of its terms.
struct Term {
    std::string name; ///< "specular", "light 'key'", "off-diagonal K"
    Scene without;
};

/// Diffuse and specular term, off-diagonal entries of K, roughness, interreflection, each light, surroundings: those that the scene has.
[[nodiscard]] std::vector<Term> termsOf(const Scene& scene);

struct TermFigures {
    std::string name;
    ErrorFigures buys;         ///< how far the picture is off without the term
    double milliseconds = 0.0; ///< what shading again takes less without it; below 0 where that saves nothing
    double spread = 0.0;       ///< of these milliseconds
};

struct TermBars {
    Timing whole; ///< shading with all terms: SIMD, on the CPU
    std::vector<TermFigures> terms;
};

/// Pictures in double, times in SIMD, interleaved. Nothing where stopped.
[[nodiscard]] std::optional<TermBars> termBars(const Scene& scene, const RenderSettings& settings, int repetitions,
                                               Progress* progress = nullptr);

} // namespace reflectance
