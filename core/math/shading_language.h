// The functions of GLSL that shared texts call, for float and double. SIMD lanes bring their own.
#pragma once

#include "core/math/lobe.h"
#include "core/math/vec.h"

#include <algorithm>
#include <cmath>

namespace reflectance {

// Without these, floor(x) of a float in a text would find the C library's double function.
using std::abs;
using std::exp2;
using std::floor;
using std::pow;
using std::sqrt;

[[nodiscard]] inline double max(double a, double b)
{
    return std::max(a, b);
}
[[nodiscard]] inline float max(float a, float b)
{
    return std::max(a, b);
}
[[nodiscard]] inline double min(double a, double b)
{
    return std::min(a, b);
}
[[nodiscard]] inline float min(float a, float b)
{
    return std::min(a, b);
}

/// x kept within low .. high.
template <class T> [[nodiscard]] T clamp(const T& x, const T& low, const T& high)
{
    return min(max(x, low), high);
}

/// a at share 0, b at share 1.
template <class T> [[nodiscard]] T mix(const T& a, const T& b, const T& share)
{
    return a * (lit<T>(1.0) - share) + b * share;
}
template <class T> [[nodiscard]] Vec3<T> mix(const Vec3<T>& a, const Vec3<T>& b, const T& share)
{
    return a * (lit<T>(1.0) - share) + b * share;
}

/// 0 up to `low`, 1 from `high`, the cubic 3t^2 - 2t^3 between; low < high.
template <class T> [[nodiscard]] T smoothstep(const T& low, const T& high, const T& x)
{
    const T t = clamp((x - low) / (high - low), lit<T>(0.0), lit<T>(1.0));
    return t * t * (lit<T>(3.0) - lit<T>(2.0) * t);
}

} // namespace reflectance
