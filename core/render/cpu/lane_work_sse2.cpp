// Rays and surface points for any x86-64 processor, and the choice for this one.
#include "core/base/processor.h"
#include "core/render/cpu/lane_loops.h"

namespace reflectance {

const LaneWork& laneWorkSse2()
{
    static constexpr LaneWork work = makeLaneWork<xsimd::batch<double, xsimd::sse2>>();
    return work;
}

const LaneWork& laneWork()
{
    return hasAvx2() ? laneWorkAvx2() : laneWorkSse2();
}

} // namespace reflectance
