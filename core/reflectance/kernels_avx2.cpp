// The models in SIMD lanes for processors with AVX2 and FMA.
#include "core/reflectance/kernel_lanes.h"

#include "core/reflectance/kernel_tables.h"
#include "core/reflectance/lobe_kernels.h"
#include "models.gen.h"

namespace reflectance {
namespace {

using Lanes = xsimd::batch<float, xsimd::fma3<xsimd::avx2>>;

#define KERNEL(model) lanesKernel<models::model<Lanes>, Lanes>(),
constexpr Kernel<float> kernels[] = {REFLECTANCE_FOR_EACH_MODEL(KERNEL)};
#undef KERNEL

#define KERNEL(model) lanesKernel<models::model<Lanes, Lobe>, Lanes>(),
template <template <class> class Lobe>
constexpr Kernel<float> kernelsWith[] = {REFLECTANCE_FOR_EACH_MODEL_WITH_LOBE(KERNEL)};
#undef KERNEL

#define FORM(Lobe) kernelsWith<Lobe>,
constexpr const Kernel<float>* otherForms[] = {REFLECTANCE_FOR_EACH_OTHER_LOBE(FORM)};
#undef FORM

#define SPECIAL(model, K, ks, facing)                                                                                  \
    lanesKernel<                                                                                                       \
        FacingIf<models::model<Lanes, ConditionedLobe, MatrixOf<Lanes, K>, ColorOf<Lanes, ks>>, Lanes, facing>,        \
        Lanes>(),
constexpr Kernel<float> specials[] = {REFLECTANCE_FOR_EACH_SPECIAL(SPECIAL)};
#undef SPECIAL

} // namespace

const Kernel<float>* specialLanesKernelsAvx2()
{
    return specials;
}

const Kernel<float>* lanesKernelsAvx2()
{
    return kernels;
}

const Kernel<float>* lanesKernelsAvx2(LobeForm form)
{
    return otherForms[otherLobe(form)];
}

} // namespace reflectance
