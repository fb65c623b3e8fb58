// The kernels of all models, one table per number type and instruction set.
#pragma once

#include "core/reflectance/kernel.h"
#include "core/reflectance/lobe_form.h"
#include "core/reflectance/special_form.h"

#include <span>
#include <string_view>

namespace reflectance {

/// A special form that has kernels of its own.
struct SpecialRow {
    std::string_view model;
    SpecialForm form;
};

[[nodiscard]] std::span<const SpecialRow> specialRows();

/// The kernels of one number type on one instruction set.
template <class S> struct KernelTable {
    const Kernel<S>* models = nullptr;            ///< in the order of the catalogue
    const Kernel<S>* specials = nullptr;          ///< in the order of specialRows
    const Kernel<S>* const* otherForms = nullptr; ///< per form of the lobe but the conditioned one; null: none

    /// The models that call the lobe, in the order of the catalogue, with that form; not the conditioned one.
    [[nodiscard]] const Kernel<S>* with(LobeForm form) const { return otherForms[static_cast<std::size_t>(form) - 1]; }
};

[[nodiscard]] const KernelTable<float>& floatKernels();
[[nodiscard]] const KernelTable<float>& lanesKernelsSse2();
[[nodiscard]] const KernelTable<float>& lanesKernelsAvx2(); ///< call only where the processor has AVX2 and FMA

/// The truth, in double. Runs in lanes too, and gives the same bits on every instruction set; those of one of them have no
/// other forms of the lobe.
[[nodiscard]] const KernelTable<double>& doubleKernels();
[[nodiscard]] const KernelTable<double>& doubleKernelsSse2();
[[nodiscard]] const KernelTable<double>& doubleKernelsAvx2(); ///< as above

/// The widest float lanes that this processor runs, chosen once.
[[nodiscard]] const KernelTable<float>& lanesKernels();
/// "avx2" or "sse2".
[[nodiscard]] const char* lanesName();

} // namespace reflectance
