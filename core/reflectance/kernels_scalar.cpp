// The models in scalar float, the other forms of the lobe in scalar double, and the choice of lanes for this processor.
#include "core/base/processor.h"
#include "core/reflectance/kernel_lists.h"

namespace reflectance {

std::span<const SpecialRow> specialRows()
{
#define SPECIAL(model, K, ks, facing) {#model, {K, ks, facing}},
    static constexpr SpecialRow rows[] = {REFLECTANCE_FOR_EACH_SPECIAL(SPECIAL)};
#undef SPECIAL
    return rows;
}

const KernelTable<float>& floatKernels()
{
    static constexpr KernelTable<float> table{modelKernels<float>, specials<float>, otherForms<float>};
    return table;
}

const KernelTable<double>& doubleKernels()
{
    static const KernelTable<double> table = [] {
        KernelTable<double> lanes = hasAvx2() ? doubleKernelsAvx2() : doubleKernelsSse2();
        lanes.otherForms = otherForms<double>;
        return lanes;
    }();
    return table;
}

const KernelTable<float>& lanesKernels()
{
    return hasAvx2() ? lanesKernelsAvx2() : lanesKernelsSse2();
}

const char* lanesName()
{
    return hasAvx2() ? "avx2" : "sse2";
}

} // namespace reflectance
