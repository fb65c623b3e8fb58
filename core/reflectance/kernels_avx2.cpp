// The models in SIMD lanes for processors with AVX2 and FMA.
#include "core/reflectance/kernel_lanes.h"

#include "core/reflectance/kernel_tables.h"
#include "models.gen.h"

namespace reflectance {

const Kernel<float>* lanesKernelsAvx2()
{
    using Lanes = xsimd::batch<float, xsimd::fma3<xsimd::avx2>>;
#define KERNEL(model) lanesKernel<models::model, Lanes>(),
    static constexpr Kernel<float> kernels[] = {REFLECTANCE_FOR_EACH_MODEL(KERNEL)};
#undef KERNEL
    return kernels;
}

} // namespace reflectance
