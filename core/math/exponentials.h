// The lobe's logarithm and exponential, as one text for double, float and SIMD lanes: no branch, no library, and in double no
// operation but those that IEEE rounds, so that every processor and every width of lanes gives the same bits.
//
// Whole numbers go in and out by magic numbers: x + 1.5 2^m, m the bits of the mantissa, holds round(x) in its lowest bits.
#pragma once

#include "core/math/number_bits.h"
#include "core/math/vec.h"

#include <array>

namespace reflectance {

/// The polynomials that suffice for a number type, lowest power first: Q with log2(m) = s Q(s^2), s = (m - 1) / (m + 1), for m
/// from sqrt(1/2) to sqrt(2), and P = 2^r for |r| <= 1/2. Both have the least largest relative error (Remez); it is below
/// 0.032 units in the last place, so that roundings are all there is.
template <class S> struct Exponentials;

template <> struct Exponentials<double> {
    static constexpr std::array Q{2.8853900817779268114,  0.96179669392598983025, 0.57707801634546432218,
                                  0.41219858585244695792, 0.32059853377885615431, 0.26233440976742066754,
                                  0.22091165217235549983, 0.21367302320686334779};
    static constexpr std::array P{0.9999999999999999971,     0.69314718055994533045,     0.24022650695910156194,
                                  0.055504108664819921999,   0.0096181291075883388805,   0.001333355814678983701,
                                  0.00015403530462509966101, 0.000015252733490062370866, 1.3215433091851149785e-6,
                                  1.0178197993382467131e-7,  7.0741052512368323548e-9,   4.4352866745874167032e-10};
};

template <> struct Exponentials<float> {
    static constexpr std::array Q{2.88539007979F, 0.961798848284F, 0.576714310739F, 0.431737877884F};
    static constexpr std::array P{1.00000000055F,    0.693147205736F,   0.240226468912F,   0.0555032877851F,
                                  0.00961848889795F, 0.00133999307896F, 0.000153458273815F};
};

template <class T, class S, std::size_t count>
[[nodiscard]] T polynomial(const std::array<S, count>& coefficients, const T& x)
{
    T sum(coefficients[count - 1]);
    for (std::size_t i = count - 1; i-- > 0;)
        sum = multiplyAdd(sum, x, T(coefficients[i]));
    return sum;
}

/// log2(u) of a normal number u from 0 to 1; where u >= sqrt(1/2), of 1 + x, which has all its digits where u = 1 + x has
/// lost them. Off by about two units in the last place. Anything may come of other numbers.
template <class T> [[nodiscard, gnu::always_inline]] inline T log2Of(const T& u, const T& x)
{
    using S = typename ScalarOf<T>::type;
    using Layout = NumberBits<S>;
    using Bits = decltype(bitsOf(u)); // as many as there are lanes
    constexpr S rootOfHalf = S(0.70710678118654752440);
    constexpr S magic = S(std::uint64_t(1) << Layout::mantissa);
    constexpr auto low = std::bit_cast<typename Layout::Bits>(rootOfHalf);
    constexpr auto one = std::bit_cast<typename Layout::Bits>(S(1));
    constexpr auto mask = (typename Layout::Bits(1) << Layout::mantissa) - 1;
    // u = 2^k m: adding 1 - sqrt(1/2), as bits, carries into the exponent where m would pass sqrt(2).
    const Bits shifted = bitsOf(u) + Bits(one - low);
    const T m = fromBits((shifted & Bits(mask)) + Bits(low));
    const Bits exponent = (shifted >> Layout::mantissa) | Bits(std::bit_cast<typename Layout::Bits>(magic));
    const T k = fromBits(exponent) - T(magic + S(Layout::bias));
    const T above = choose(u >= T(rootOfHalf), x, m - T(S(1)));
    const T s = above / (T(S(2)) + above);
    return multiplyAdd(s, polynomial(Exponentials<S>::Q, s * s), k);
}

/// 2^y for y <= 0, and 0 below the smallest normal number: subnormal numbers triple the time of a kernel. NaN gives 0.
template <class T> [[nodiscard, gnu::always_inline]] inline T exp2OrZero(const T& y)
{
    using S = typename ScalarOf<T>::type;
    using Layout = NumberBits<S>;
    constexpr S magic = S(std::uint64_t(3) << (Layout::mantissa - 1));
    const T shifted = y + T(magic);
    const T power = polynomial(Exponentials<S>::P, y - (shifted - T(magic)));
    return choose(y >= T(S(1 - Layout::bias)), fromBits(bitsOf(power) + (bitsOf(shifted) << Layout::mantissa)));
}

} // namespace reflectance
