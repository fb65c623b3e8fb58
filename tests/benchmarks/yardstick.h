// A hand-written kernel to measure the shipped ones by.
#pragma once

#include "core/reflectance/kernel.h"

namespace reflectance {

/// The values are the hybrid's, with one number for ks; whole registers only. Call only where the processor has AVX2 and FMA.
void yardstickHybrid(const double* values, const ShadeBatch<float>& batch);

} // namespace reflectance
