// The loops of triangle_loops.h in lanes B of doubles. Included by the triangle_loops_<set>.cpp only, each compiled for its
// own processor; nothing here may be called elsewhere.
#pragma once

#include "core/math/lanes.h" // before the formulas: the choices of lanes are looked up where a formula is written

#include "core/geometry/arctangent.h"
#include "core/geometry/triangle_loops.h"

namespace reflectance {

template <class B> Vec3<B> cornersAt(const TriangleBlock& block, std::size_t corner, std::size_t i)
{
    const auto& axes = block.coordinates[corner];
    return {B::load_unaligned(axes[0].data() + i), B::load_unaligned(axes[1].data() + i),
            B::load_unaligned(axes[2].data() + i)};
}

template <class B> void anglesOf(const TriangleBlock& block, AngleBlock& found)
{
    for (std::size_t i = 0; i < TriangleBlock::capacity; i += B::size) {
        const TriangleSides<B> sides(cornersAt<B>(block, 0, i), cornersAt<B>(block, 1, i), cornersAt<B>(block, 2, i));
        const Vec3<B> n = sides.normal();
        const B sine = xsimd::sqrt(dot(n, n));
        arctangent(sine, dot(sides.ab, sides.ac)).store_unaligned(found.angles[0].data() + i);
        arctangent(sine, B(-dot(sides.ab, sides.bc))).store_unaligned(found.angles[1].data() + i);
        arctangent(sine, dot(sides.ac, sides.bc)).store_unaligned(found.angles[2].data() + i);
        sides.size().store_unaligned(found.sizes.data() + i);
    }
}

template <class B> void normalsOf(const TriangleBlock& block, NormalBlock& found)
{
    for (std::size_t i = 0; i < TriangleBlock::capacity; i += B::size) {
        const Vec3<B> a = cornersAt<B>(block, 0, i);
        const Vec3<B> b = cornersAt<B>(block, 1, i);
        const Vec3<B> c = cornersAt<B>(block, 2, i);
        const TriangleSides<B> sides(a, b, c);
        const B size = sides.size();
        const B extent = extentOf(a, b, c);
        const Vec3<B> normal = sides.normal();
        const B sine = xsimd::sqrt(dot(normal, normal));
        size.store_unaligned(found.sizes.data() + i);
        extent.store_unaligned(found.extents.data() + i);
        B(sine - roundingOf(extent, size)).store_unaligned(found.excess.data() + i);
        B(normal.x / sine).store_unaligned(found.normals[0].data() + i);
        B(normal.y / sine).store_unaligned(found.normals[1].data() + i);
        B(normal.z / sine).store_unaligned(found.normals[2].data() + i);
    }
}

template <class B> constexpr TriangleLoops makeTriangleLoops()
{
    return {&anglesOf<B>, &normalsOf<B>};
}

} // namespace reflectance
