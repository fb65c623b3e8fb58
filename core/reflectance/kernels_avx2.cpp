// The models in float lanes for processors with AVX2 and FMA.
#include "core/reflectance/kernel_lanes.h"

#include "core/reflectance/kernel_lists.h"

namespace reflectance {

const KernelTable<float>& lanesKernelsAvx2()
{
    using Lanes = xsimd::batch<float, xsimd::fma3<xsimd::avx2>>;
    static constexpr KernelTable<float> table{modelKernels<Lanes>, specials<Lanes>, otherForms<Lanes>};
    return table;
}

} // namespace reflectance
