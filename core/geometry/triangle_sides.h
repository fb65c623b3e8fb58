// The three sides of a triangle, and the normal that they span.
#pragma once

#include "core/math/vec.h"

#include <algorithm>

namespace reflectance {

[[nodiscard]] inline double largestComponent(const Vec3d& v)
{
    return std::max(std::max(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z));
}

/// Written without branches, for loops over many triangles.
struct TriangleSides {
    Vec3d ab, ac, bc;

    TriangleSides(const Vec3d& a, const Vec3d& b, const Vec3d& c) : ab(b - a), ac(c - a), bc(c - b) {}

    /// The longest side, to within a factor of the root of 3.
    [[nodiscard]] double size() const
    {
        return std::max(std::max(largestComponent(ab), largestComponent(ac)), largestComponent(bc));
    }

    /// Whether products of four lengths neither overflow nor lose digits.
    [[nodiscard]] static bool isHandy(double size) { return size > 1e-30 && size < 1e30; }

    /// Along the normal by the winding, as long as twice the area. The two shorter sides meet at the widest angle, where
    /// the cross product is best conditioned; all three pairs turn the same way.
    [[nodiscard]] Vec3d normal() const
    {
        const double abab = dot(ab, ab);
        const double acac = dot(ac, ac);
        const double bcbc = dot(bc, bc);
        const bool isAcLongest = acac >= abab && acac >= bcbc;
        const bool isBcLongest = !isAcLongest && bcbc >= abab;
        return cross(chosen(isAcLongest || isBcLongest, ab, ac), chosen(isBcLongest, ac, bc));
    }

private:
    static Vec3d chosen(bool first, const Vec3d& a, const Vec3d& b)
    {
        return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
    }
};

} // namespace reflectance
