// The formula of surface_point.h, for one sample or for lanes of them.
#pragma once

#include "core/math/number_bits.h"
#include "core/math/vec.h"

namespace reflectance {

/// A triangle by one corner and the edges from there, in the order of its winding.
template <class T> struct Span {
    Vec3<T> corner, edge1, edge2;
};

/// Weights of a triangle's second and third corner.
template <class T> struct Barycentrics {
    T u, v;
};

/// Where a ray meets the triangle's plane; not finite where the ray runs in it.
template <class T>
[[nodiscard]] Barycentrics<T> crossing(const Span<T>& triangle, const Vec3<T>& eye, const Vec3<T>& direction)
{
    const Vec3<T> fromCorner = eye - triangle.corner;
    const Vec3<T> p = cross(direction, triangle.edge2);
    const Vec3<T> q = cross(fromCorner, triangle.edge1);
    const T determinant = dot(triangle.edge1, p);
    return {dot(fromCorner, p) / determinant, dot(direction, q) / determinant};
}

/// The nearest inside, of finite ones.
template <class T> [[nodiscard]] Barycentrics<T> insideTriangle(const Barycentrics<T>& met)
{
    const T zero(0.0), one(1.0);
    const T u = choose(met.u < zero, zero, met.u);
    const T v = choose(met.v < zero, zero, met.v);
    const T sum = choose(u + v < one, one, u + v);
    return {u / sum, v / sum};
}

template <class T> [[nodiscard]] Vec3<T> positionAt(const Span<T>& triangle, const Barycentrics<T>& at)
{
    return triangle.corner + at.u * triangle.edge1 + at.v * triangle.edge2;
}

/// Vertex normals interpolated; of any length.
template <class T>
[[nodiscard]] Vec3<T> normalAt(const Vec3<T>& first, const Vec3<T>& second, const Vec3<T>& third,
                               const Barycentrics<T>& at)
{
    return (T(1.0) - at.u - at.v) * first + at.u * second + at.v * third;
}

} // namespace reflectance
