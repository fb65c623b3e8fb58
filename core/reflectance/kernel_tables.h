// The kernels of all models, in the order of the catalogue, one table per number type and instruction set.
#pragma once

#include "core/reflectance/kernel.h"

namespace reflectance {

[[nodiscard]] const Kernel<double>* doubleKernels();
[[nodiscard]] const Kernel<float>* floatKernels();
[[nodiscard]] const Kernel<float>* lanesKernelsSse2();
[[nodiscard]] const Kernel<float>* lanesKernelsAvx2(); ///< call only where the processor has AVX2 and FMA

/// The widest lanes that this processor runs, chosen once.
[[nodiscard]] const Kernel<float>* lanesKernels();
/// "avx2" or "sse2".
[[nodiscard]] const char* lanesName();

} // namespace reflectance
