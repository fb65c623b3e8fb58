// What `trade` answers without trying everything on the whole picture: the dial, the map of models that suffice, the terms.
#pragma once

#include "core/render/gl/gl_renderer.h"
#include "core/study/trade/dial.h"

#include <string>

namespace reflectance::cli {

/// Each prints its answer, writes it to `json` (unless "") and returns the exit code.
[[nodiscard]] int answerDial(const Scene& scene, const RenderSettings& settings, const DialWish& wish, GlRenderer* gl,
                             const std::string& json);

/// Paints `file`, a PNG.
[[nodiscard]] int answerMap(const Scene& scene, const RenderSettings& settings, double tolerance, Metric metric,
                            const std::string& file, const std::string& json);

[[nodiscard]] int answerTerms(const Scene& scene, const RenderSettings& settings, int repetitions,
                              const std::string& json);

} // namespace reflectance::cli
