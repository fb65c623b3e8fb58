// For processors with AVX2; products and sums are never fused, see core/math/lanes.h.
#include "core/geometry/triangle_loops_lanes.h"

namespace reflectance {

const TriangleLoops& triangleLoopsAvx2()
{
    static constexpr TriangleLoops loops = makeTriangleLoops<xsimd::batch<double, xsimd::avx2>>();
    return loops;
}

} // namespace reflectance
