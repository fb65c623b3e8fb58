// The models in double lanes for processors with AVX2; products and sums are never fused, see lanes.h.
#include "core/reflectance/kernel_lanes.h"

#include "core/reflectance/kernel_lists.h"

namespace reflectance {

const KernelTable<double>& doubleKernelsAvx2()
{
    using Lanes = xsimd::batch<double, xsimd::avx2>;
    static constexpr KernelTable<double> table{modelKernels<Lanes>, specials<Lanes>, nullptr};
    return table;
}

} // namespace reflectance
