// Rays and surface points for any x86-64 processor, and the choice for this one.
#include "core/reflectance/kernel_tables.h"
#include "core/render/cpu/lane_loops.h"

#include <string_view>

namespace reflectance {

const LaneWork& laneWorkSse2()
{
    static constexpr LaneWork work = makeLaneWork<xsimd::batch<double, xsimd::sse2>>();
    return work;
}

const LaneWork& laneWork()
{
    static const LaneWork& work = std::string_view(lanesName()) == "avx2" ? laneWorkAvx2() : laneWorkSse2();
    return work;
}

} // namespace reflectance
