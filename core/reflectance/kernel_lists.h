// The kernels of all models for one number type: a scalar, or SIMD lanes. Included by the kernels_*.cpp only, after
// kernel_lanes.h where there are lanes.
#pragma once

#include "core/reflectance/kernel_loops.h"
#include "core/reflectance/kernel_tables.h"
#include "core/reflectance/lobe_kernels.h"
#include "models.gen.h"

namespace reflectance {

#define KERNEL(model) makeKernel<models::model<T>, T>(),
template <class T> constexpr Kernel<typename ScalarOf<T>::type> modelKernels[] = {REFLECTANCE_FOR_EACH_MODEL(KERNEL)};
#undef KERNEL

#define KERNEL(model) makeKernel<models::model<T, Lobe>, T>(),
template <class T, template <class> class Lobe>
constexpr Kernel<typename ScalarOf<T>::type> kernelsWith[] = {REFLECTANCE_FOR_EACH_MODEL_WITH_LOBE(KERNEL)};
#undef KERNEL

#define FORM(Lobe) kernelsWith<T, Lobe>,
template <class T>
constexpr const Kernel<typename ScalarOf<T>::type>* otherForms[] = {REFLECTANCE_FOR_EACH_OTHER_LOBE(FORM)};
#undef FORM

#define SPECIAL(model, K, ks, facing)                                                                                  \
    makeKernel<FacingIf<models::model<T, ConditionedLobe, MatrixOf<T, K>, ColorOf<T, ks>>, T, facing>, T>(),
template <class T> constexpr Kernel<typename ScalarOf<T>::type> specials[] = {REFLECTANCE_FOR_EACH_SPECIAL(SPECIAL)};
#undef SPECIAL

} // namespace reflectance
