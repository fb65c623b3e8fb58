// The three sides of a triangle, and the normal that they span: of one, or of as many as a lane holds.
#pragma once

#include "core/math/number_bits.h"
#include "core/math/vec.h"

#include <cmath>
#include <limits>

namespace reflectance {

/// As std::max: the first where they do not compare.
template <class T> [[nodiscard]] T largerOf(const T& a, const T& b)
{
    return choose(a < b, b, a);
}

template <class T> [[nodiscard]] T largestComponent(const Vec3<T>& v)
{
    using std::abs;
    return largerOf(largerOf(T(abs(v.x)), T(abs(v.y))), T(abs(v.z)));
}

template <class T> [[nodiscard]] T extentOf(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c)
{
    return largerOf(largerOf(largestComponent(a), largestComponent(b)), largestComponent(c));
}

/// To how much the cross product of a triangle's sides is known: each coordinate is known to half a unit in its last place.
template <class T> [[nodiscard]] T roundingOf(const T& extent, const T& size)
{
    return T(4.0 * std::numeric_limits<double>::epsilon()) * extent * size;
}

/// Written without branches, for loops over many triangles.
template <class T> struct TriangleSides {
    Vec3<T> ab, ac, bc;

    TriangleSides(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) : ab(b - a), ac(c - a), bc(c - b) {}

    /// The longest side, to within a factor of the root of 3.
    [[nodiscard]] T size() const { return extentOf(ab, ac, bc); }

    /// Along the normal by the winding, as long as twice the area. The two shorter sides meet at the widest angle, where
    /// the cross product is best conditioned; all three pairs turn the same way.
    [[nodiscard]] Vec3<T> normal() const
    {
        const T abab = dot(ab, ab);
        const T acac = dot(ac, ac);
        const T bcbc = dot(bc, bc);
        const auto isAcLongest = acac >= abab && acac >= bcbc;
        const auto isBcLongest = !isAcLongest && bcbc >= abab;
        return cross(chosen(isAcLongest || isBcLongest, ab, ac), chosen(isBcLongest, ac, bc));
    }

private:
    template <class Mask> static Vec3<T> chosen(const Mask& first, const Vec3<T>& a, const Vec3<T>& b)
    {
        return {choose(first, a.x, b.x), choose(first, a.y, b.y), choose(first, a.z, b.z)};
    }
};

/// Whether products of four lengths neither overflow nor lose digits.
[[nodiscard]] inline bool isHandySize(double size)
{
    return size > 1e-30 && size < 1e30;
}

} // namespace reflectance
