// The kernels of all models, in the order of the catalogue, one table per number type and instruction set.
#pragma once

#include "core/reflectance/kernel.h"
#include "core/reflectance/lobe_form.h"

namespace reflectance {

[[nodiscard]] const Kernel<double>* doubleKernels();
[[nodiscard]] const Kernel<float>* floatKernels();
[[nodiscard]] const Kernel<float>* lanesKernelsSse2();
[[nodiscard]] const Kernel<float>* lanesKernelsAvx2(); ///< call only where the processor has AVX2 and FMA

/// With another form of the lobe than the conditioned one: the models that call it, in the order of the catalogue.
[[nodiscard]] const Kernel<double>* doubleKernels(LobeForm form);
[[nodiscard]] const Kernel<float>* floatKernels(LobeForm form);
[[nodiscard]] const Kernel<float>* lanesKernelsSse2(LobeForm form);
[[nodiscard]] const Kernel<float>* lanesKernelsAvx2(LobeForm form); ///< as above
[[nodiscard]] const Kernel<float>* lanesKernels(LobeForm form);

/// The widest lanes that this processor runs, chosen once.
[[nodiscard]] const Kernel<float>* lanesKernels();
/// "avx2" or "sse2".
[[nodiscard]] const char* lanesName();

} // namespace reflectance
