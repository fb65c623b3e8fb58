// What programs usually write: v / sqrt(v.v), pow(max(R.V, 0), n), and a cosine that is compared with a cosine. Kept to
// show at which point that loses digits, and to see that the hazards find it.
#pragma once

#include "core/study/extremes/instruments.h"

namespace reflectance {

/// True for models that the textbook evaluator knows: those made of kd, K, ks and n, or reflectance.
[[nodiscard]] bool hasTextbookForm(const Model& model);

/// Instruments whose models are evaluated the textbook way, in the arithmetic asked for; GLSL runs the same formulas in
/// GLSL. SIMD lanes are float, one by one. Models without a textbook form are evaluated as `ours` does.
/// For GLSL all N, L and V of one call are taken to be as long as the first N.
[[nodiscard]] Instruments textbookInstruments(const Instruments& ours);

} // namespace reflectance
