// The models in double (the truth) and in scalar float, and the choice of SIMD lanes for this processor.
#include "core/reflectance/kernel_loops.h"
#include "core/reflectance/kernel_tables.h"
#include "models.gen.h"

namespace reflectance {
namespace {

bool hasAvx2()
{
    static const bool has = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    return has;
}

} // namespace

#define KERNEL(model) scalarKernel<models::model, Number>(),

const Kernel<double>* doubleKernels()
{
    using Number = double;
    static constexpr Kernel<double> kernels[] = {REFLECTANCE_FOR_EACH_MODEL(KERNEL)};
    return kernels;
}

const Kernel<float>* floatKernels()
{
    using Number = float;
    static constexpr Kernel<float> kernels[] = {REFLECTANCE_FOR_EACH_MODEL(KERNEL)};
    return kernels;
}

#undef KERNEL

const Kernel<float>* lanesKernels()
{
    return hasAvx2() ? lanesKernelsAvx2() : lanesKernelsSse2();
}

const char* lanesName()
{
    return hasAvx2() ? "avx2" : "sse2";
}

} // namespace reflectance
