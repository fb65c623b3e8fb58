// What the forms of the lobe ask of an exponent, which is the same for every direction and lane: whole numbers to count by.
// GLSL's text stands in shaders/lobe/counting.glsl.
#pragma once

#include "core/math/vec.h"

namespace reflectance {

/// A number that every lane shares.
[[nodiscard]] inline double sharedNumber(double n)
{
    return n;
}
[[nodiscard]] inline float sharedNumber(float n)
{
    return n;
}

/// n rounded, for n from 0 to 1e8.
template <class T> [[nodiscard]] int wholeNumber(const T& n)
{
    return static_cast<int>(sharedNumber(n) + typename ScalarOf<T>::type(0.5));
}

/// The power of two nearest to n in ratio, at most 16, as the number of squarings that reach it.
template <class T> [[nodiscard]] int squaringsFor(const T& n)
{
    const auto shared = sharedNumber(n);
    int squarings = 0;
    for (auto next = typename ScalarOf<T>::type(1.41421356); squarings < 4 && shared >= next; next *= 2)
        ++squarings;
    return squarings;
}

} // namespace reflectance
