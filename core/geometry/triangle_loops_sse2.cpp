// For every processor, and the choice of the lanes for this one.
#include "core/base/processor.h"
#include "core/geometry/triangle_loops_lanes.h"

namespace reflectance {

const TriangleLoops& triangleLoopsSse2()
{
    static constexpr TriangleLoops loops = makeTriangleLoops<xsimd::batch<double, xsimd::sse2>>();
    return loops;
}

const TriangleLoops& triangleLoops()
{
    return hasAvx2() ? triangleLoopsAvx2() : triangleLoopsSse2();
}

} // namespace reflectance
