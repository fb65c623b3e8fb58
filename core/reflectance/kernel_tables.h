// The kernels of all models, in the order of the catalogue, one table per number type and instruction set.
#pragma once

#include "core/reflectance/kernel.h"
#include "core/reflectance/lobe_form.h"
#include "core/reflectance/special_form.h"

#include <span>
#include <string_view>

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

/// A special form that has kernels of its own.
struct SpecialRow {
    std::string_view model;
    SpecialForm form;
};

/// Their kernels, in the order of specialRows.
[[nodiscard]] std::span<const SpecialRow> specialRows();
[[nodiscard]] const Kernel<double>* specialDoubleKernels();
[[nodiscard]] const Kernel<float>* specialFloatKernels();
[[nodiscard]] const Kernel<float>* specialLanesKernelsSse2();
[[nodiscard]] const Kernel<float>* specialLanesKernelsAvx2(); ///< as above
[[nodiscard]] const Kernel<float>* specialLanesKernels();

/// The widest lanes that this processor runs, chosen once.
[[nodiscard]] const Kernel<float>* lanesKernels();
/// "avx2" or "sse2".
[[nodiscard]] const char* lanesName();

} // namespace reflectance
