// An arctangent without a branch and without a library, for loops over many angles.
#pragma once

#include "core/math/number_bits.h"

#include <cmath>
#include <numbers>

namespace reflectance {

/// atan2(sine, cosine) for a sine >= 0 and a cosine that are not both zero: 0 .. pi. They need not be those of one angle,
/// only in their ratio. Off by at most 3 units in the last place. T is double, or lanes of it.
template <class T> [[nodiscard, gnu::always_inline]] inline T arctangent(const T& sine, const T& cosine)
{
    using std::abs;
    // atan(r) = r + r z Q(z), z = r^2, for |r| <= tan(pi/8), lowest power first: the polynomial of the least largest relative
    // error (Remez), 0.011 units in the last place, so that roundings are all there is.
    constexpr double Q[] = {-0.33333333333333129103,  0.19999999999942733392,   -0.14285714279417031893,
                            0.11111110752669240245,   -0.090908970192096296224, 0.076920488846111465172,
                            -0.066629904176082746239, 0.058471477427401981026,  -0.050362704432905344382,
                            0.037993873485346485028,  -0.01783567689269622686};
    constexpr double pi = std::numbers::pi;
    constexpr double tanOfEighth = 0.41421356237309504880;
    const T size = abs(cosine);
    const auto isSteep = sine > size;
    const T low = choose(isSteep, size, sine);
    const T high = choose(isSteep, sine, size);
    // Beyond pi/8 what is left of pi/4: tan(a - pi/4) = (tan a - 1) / (tan a + 1). One division serves both.
    const auto isWide = low > T(tanOfEighth) * high;
    const T r = choose(isWide, low - high, low) / choose(isWide, low + high, high);
    const T z = r * r;
    T sum(Q[10]);
    for (int i = 9; i >= 0; --i)
        sum = sum * z + T(Q[i]);
    const T small = choose(isWide, T(0.25 * pi), T(0.0)) + (r + r * (z * sum));
    const T acute = choose(isSteep, T(0.5 * pi) - small, small);
    return choose(cosine < T(0.0), T(pi) - acute, acute);
}

} // namespace reflectance
