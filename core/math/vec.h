// Three-vectors and 3x3 matrices over any number type: double, float or SIMD lanes.
// GLM serves camera and transforms; it rejects SIMD lanes, so the model texts compute on these.
#pragma once

#include <cmath>

namespace reflectance {

/// The plain number inside T: T itself, or the element type of SIMD lanes (specialised in lanes.h).
template <class T> struct ScalarOf {
    using type = T;
};

/// A literal of a model text, exact in T ("0.33" must not pass through float on its way to double).
template <class T> [[nodiscard]] constexpr T lit(double value)
{
    return T(static_cast<typename ScalarOf<T>::type>(value));
}

template <class T> struct Vec3 {
    T x{}, y{}, z{};

    constexpr Vec3() = default;
    constexpr Vec3(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
    constexpr explicit Vec3(T all) : x(all), y(all), z(all) {}
    template <class U>
    constexpr explicit Vec3(const Vec3<U>& v) : x(static_cast<T>(v.x)), y(static_cast<T>(v.y)), z(static_cast<T>(v.z))
    {
    }

    constexpr Vec3& operator+=(const Vec3& v)
    {
        x += v.x;
        y += v.y;
        z += v.z;
        return *this;
    }

    friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(const Vec3& a, const Vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend constexpr Vec3 operator*(const Vec3& a, const T& s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3 operator*(const T& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr Vec3 operator/(const Vec3& a, const T& s) { return {a.x / s, a.y / s, a.z / s}; }
    // Not defaulted: clang would compare SIMD lanes too, and they have no single answer.
    friend constexpr bool operator==(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

template <class T> [[nodiscard]] constexpr T dot(const Vec3<T>& a, const Vec3<T>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T> [[nodiscard]] constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline double length(const Vec3d& v)
{
    return std::hypot(v.x, v.y, v.z);
}

/// Unit vector along v for any length from 5e-324 to 1e308: the largest component is divided out first.
/// The zero vector and vectors with NaN or infinite components give (0,0,0). Hazards H10 to H12.
[[nodiscard]] inline Vec3d normalized(const Vec3d& v)
{
    // Where the square can neither overflow nor lose digits, scaling by a power of two would not change a bit.
    if (const double squared = dot(v, v); squared > 1e-200 && squared < 1e200)
        return v / std::sqrt(squared);
    const double largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
    if (!(largest > 0.0) || !std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        return {};
    // A power of two scales without rounding; ldexp in two steps reaches the subnormals.
    const int exponent = std::ilogb(largest);
    const auto scaled = [exponent](double c) { return std::ldexp(std::ldexp(c, -(exponent / 2)), -(exponent - exponent / 2)); };
    const Vec3d s{scaled(v.x), scaled(v.y), scaled(v.z)};
    return s / std::sqrt(dot(s, s));
}

/// Matrix stored by rows, as the lecture writes K: rows[i][j] says how much of light primary j reaches sensor i.
template <class T> struct Mat3 {
    Vec3<T> rows[3];

    friend constexpr Vec3<T> operator*(const Mat3& m, const Vec3<T>& v)
    {
        return {dot(m.rows[0], v), dot(m.rows[1], v), dot(m.rows[2], v)};
    }
};

using Mat3d = Mat3<double>;

} // namespace reflectance
