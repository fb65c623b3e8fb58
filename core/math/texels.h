// GLSL's buffer textures for shared texts: arrays of four numbers, looked up by their place.
#pragma once

#include "core/math/vec.h"

#include <cstddef>

namespace reflectance {

template <class T> struct Vec4 {
    T x{}, y{}, z{}, w{};

    constexpr Vec4() = default;
    constexpr Vec4(T x_, T y_, T z_, T w_) : x(x_), y(y_), z(z_), w(w_) {}
};

/// Four numbers per texel; whoever makes it keeps them alive.
template <class T> struct TexelBuffer {
    const T* numbers = nullptr;
};

template <class T> [[nodiscard]] Vec4<T> texelFetch(const TexelBuffer<T>& buffer, int texel)
{
    const T* at = buffer.numbers + 4 * static_cast<std::ptrdiff_t>(texel);
    return {at[0], at[1], at[2], at[3]};
}

} // namespace reflectance
