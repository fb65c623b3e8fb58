// The models in SIMD lanes for processors with SSE2 (every x86-64).
#include "core/reflectance/kernel_lanes.h"

#include "core/reflectance/kernel_lists.h"

namespace reflectance {

const KernelTable<float>& lanesKernelsSse2()
{
    using Lanes = xsimd::batch<float, xsimd::sse2>;
    static constexpr KernelTable<float> table{modelKernels<Lanes>, specials<Lanes>, otherForms<Lanes>};
    return table;
}

const KernelTable<double>& doubleKernelsSse2()
{
    using Lanes = xsimd::batch<double, xsimd::sse2>;
    static constexpr KernelTable<double> table{modelKernels<Lanes>, specials<Lanes>, nullptr};
    return table;
}

} // namespace reflectance
