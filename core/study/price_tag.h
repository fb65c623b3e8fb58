// The first price tag: what float, SIMD and GL cost and how far they are from double, on this very scene.
#pragma once

#include "core/render/gl/gl_renderer.h"
#include "core/render/settings.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace reflectance {

struct PriceTag {
    std::string name;                 ///< "double", "float", "simd (avx2)", "gl"
    double milliseconds = 0.0;        ///< one re-shading of the kept samples: median of the repetitions
    double maxError = 0.0;            ///< largest absolute difference of a linear channel to double on the same samples
    double rmse = 0.0;                ///< over all channels of the covered pixels
    int worstX = -1, worstY = -1;     ///< pixel of maxError; -1 where there is none
    double generalMilliseconds = 0.0; ///< a re-shading that leaves nothing out; 0 where it was not measured
};

/// Measures double, float and simd, and GL too where a renderer is given (its context current).
/// GL is held against double on the samples that GL itself drew, so that coverage is no part of the difference.
[[nodiscard]] std::vector<PriceTag> priceTags(const Scene& scene, const RenderSettings& settings, GlRenderer* gl,
                                              int repetitions = 5);

} // namespace reflectance
