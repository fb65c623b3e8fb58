// What model texts ask of two directions, formed without cancellation; GLSL's text stands in shaders/prelude.glsl. Always part
// of the loop that shades: a call hands lanes over through memory.
#pragma once

#include "core/math/exponentials.h"
#include "core/math/shading_language.h"

#include <limits>
#include <numbers>

namespace reflectance {

/// Component by component, as in GLSL.
template <class T> [[nodiscard]] Vec3<T> operator/(const Vec3<T>& a, const Vec3<T>& b)
{
    return {a.x / b.x, a.y / b.y, a.z / b.z};
}

/// asin(x) for 0 <= x <= sqrt(1/2).
[[nodiscard]] inline double arcsine(double x)
{
    return std::asin(x);
}
[[nodiscard]] inline float arcsine(float x)
{
    return std::asin(x);
}

/// exp(y) for y <= 0; 0 below the smallest normal number.
template <class T> [[nodiscard, gnu::always_inline]] inline T expOrZero(const T& y)
{
    return exp2OrZero(y * lit<T>(std::numbers::log2e));
}

/// The angle between unit vectors, in radians: 2 asin(|A - B| / 2), and pi less that of A and -B beyond a right angle.
/// acos of the dot product would lose half of the digits near 0 and pi.
template <class T> [[nodiscard, gnu::always_inline]] inline T angleBetween(const Vec3<T>& A, const Vec3<T>& B)
{
    const Vec3<T> apart = A - B;
    const Vec3<T> sum = A + B;
    const T toB = dot(apart, apart);
    const T toOpposite = dot(sum, sum);
    const T halfAngle = arcsine(lit<T>(0.5) * sqrt(min(toB, toOpposite)));
    return lit<T>(2.0) * halfAngle + gate(toB - toOpposite, lit<T>(std::numbers::pi) - lit<T>(4.0) * halfAngle);
}

/// The unit vector half way between unit vectors: the normal that would mirror L to V. (0,0,0) where L = -V.
/// L + V stands square on L - V only if both are equally long, which rounded unit vectors are not: where they point apart
/// that would tilt a short sum, so its part along L - V is taken out. The sum is scaled before it is squared, since it
/// may be as short as the smallest number.
template <class T> [[nodiscard, gnu::always_inline]] inline Vec3<T> halfway(const Vec3<T>& L, const Vec3<T>& V)
{
    const T smallest(std::numeric_limits<typename ScalarOf<T>::type>::min());
    const Vec3<T> apart = L - V;
    const Vec3<T> rough = L + V;
    const Vec3<T> sum = rough - (dot(rough, apart) / max(dot(apart, apart), lit<T>(2.0))) * apart;
    const T largest = max(max(abs(sum.x), abs(sum.y)), abs(sum.z));
    const Vec3<T> scaled = sum * (lit<T>(1.0) / max(largest, smallest));
    return scaled / sqrt(max(dot(scaled, scaled), lit<T>(1.0)));
}

} // namespace reflectance
