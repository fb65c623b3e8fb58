// The models in double (the truth) and in scalar float, and the choice of SIMD lanes for this processor.
#include "core/reflectance/kernel_loops.h"
#include "core/reflectance/kernel_tables.h"
#include "core/reflectance/lobe_kernels.h"
#include "models.gen.h"

namespace reflectance {
namespace {

bool hasAvx2()
{
    static const bool has = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    return has;
}

#define KERNEL(model) scalarKernel<models::model<T>, T>(),
template <class T> constexpr Kernel<T> kernels[] = {REFLECTANCE_FOR_EACH_MODEL(KERNEL)};
#undef KERNEL

#define KERNEL(model) scalarKernel<models::model<T, Lobe>, T>(),
template <class T, template <class> class Lobe>
constexpr Kernel<T> kernelsWith[] = {REFLECTANCE_FOR_EACH_MODEL_WITH_LOBE(KERNEL)};
#undef KERNEL

#define FORM(Lobe) kernelsWith<T, Lobe>,
template <class T> constexpr const Kernel<T>* otherForms[] = {REFLECTANCE_FOR_EACH_OTHER_LOBE(FORM)};
#undef FORM

#define SPECIAL(model, K, ks, facing)                                                                                  \
    scalarKernel<FacingIf<models::model<T, ConditionedLobe, MatrixOf<T, K>, ColorOf<T, ks>>, T, facing>, T>(),
template <class T> constexpr Kernel<T> specials[] = {REFLECTANCE_FOR_EACH_SPECIAL(SPECIAL)};
#undef SPECIAL

} // namespace

std::span<const SpecialRow> specialRows()
{
#define SPECIAL(model, K, ks, facing) {#model, {K, ks, facing}},
    static constexpr SpecialRow rows[] = {REFLECTANCE_FOR_EACH_SPECIAL(SPECIAL)};
#undef SPECIAL
    return rows;
}

const Kernel<double>* specialDoubleKernels()
{
    return specials<double>;
}

const Kernel<float>* specialFloatKernels()
{
    return specials<float>;
}

const Kernel<float>* specialLanesKernels()
{
    return hasAvx2() ? specialLanesKernelsAvx2() : specialLanesKernelsSse2();
}

const Kernel<double>* doubleKernels()
{
    return kernels<double>;
}

const Kernel<float>* floatKernels()
{
    return kernels<float>;
}

const Kernel<double>* doubleKernels(LobeForm form)
{
    return otherForms<double>[otherLobe(form)];
}

const Kernel<float>* floatKernels(LobeForm form)
{
    return otherForms<float>[otherLobe(form)];
}

const Kernel<float>* lanesKernels()
{
    return hasAvx2() ? lanesKernelsAvx2() : lanesKernelsSse2();
}

const Kernel<float>* lanesKernels(LobeForm form)
{
    return hasAvx2() ? lanesKernelsAvx2(form) : lanesKernelsSse2(form);
}

const char* lanesName()
{
    return hasAvx2() ? "avx2" : "sse2";
}

} // namespace reflectance
