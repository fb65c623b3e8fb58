// Rays and surface points for processors with AVX2; products and sums are never fused, see lanes.h.
#include "core/render/cpu/lane_loops.h"

namespace reflectance {

const LaneWork& laneWorkAvx2()
{
    static constexpr LaneWork work = makeLaneWork<xsimd::batch<double, xsimd::avx2>>();
    return work;
}

} // namespace reflectance
