// SIMD lanes as a number type for the model texts. One arithmetic, any instruction set: A is an xsimd architecture.
#pragma once

#include "core/math/number_bits.h"
#include "core/math/vec.h"

#include <cmath>
#include <cstdint>
#include <xsimd/xsimd.hpp>

namespace reflectance {

template <class S, class A> struct ScalarOf<xsimd::batch<S, A>> {
    using type = S;
};

// See number_bits.h.
template <class S, class A> [[nodiscard]] auto bitsOf(const xsimd::batch<S, A>& x)
{
    return xsimd::bitwise_cast<xsimd::batch<typename NumberBits<S>::Bits, A>>(x);
}
template <class A> [[nodiscard]] xsimd::batch<double, A> fromBits(const xsimd::batch<std::uint64_t, A>& bits)
{
    return xsimd::bitwise_cast<xsimd::batch<double, A>>(bits);
}
template <class A> [[nodiscard]] xsimd::batch<float, A> fromBits(const xsimd::batch<std::uint32_t, A>& bits)
{
    return xsimd::bitwise_cast<xsimd::batch<float, A>>(bits);
}
template <class S, class A>
[[nodiscard]] xsimd::batch<S, A> choose(const xsimd::batch_bool<S, A>& first, const xsimd::batch<S, A>& a,
                                        const xsimd::batch<S, A>& b)
{
    return xsimd::select(first, a, b);
}
/// The mask itself, over the bits: of a choice between a number and 0 compilers make two instructions more.
template <class S, class A>
[[nodiscard]] xsimd::batch<S, A> choose(const xsimd::batch_bool<S, A>& open, const xsimd::batch<S, A>& a)
{
    return a & xsimd::batch<S, A>(open.data);
}
template <class S, class A>
[[nodiscard]] xsimd::batch<S, A> gate(const xsimd::batch<S, A>& condition, const xsimd::batch<S, A>& value)
{
    return choose(condition > xsimd::batch<S, A>(S(0)), value);
}
/// In float one rounding where the processor can; in double always two, so that all processors agree.
template <class A>
[[nodiscard]] xsimd::batch<float, A> multiplyAdd(const xsimd::batch<float, A>& a, const xsimd::batch<float, A>& b,
                                                 const xsimd::batch<float, A>& c)
{
    return xsimd::fma(a, b, c);
}
template <class A>
[[nodiscard]] xsimd::batch<double, A> multiplyAdd(const xsimd::batch<double, A>& a, const xsimd::batch<double, A>& b,
                                                  const xsimd::batch<double, A>& c)
{
    return a * b + c;
}
template <class A>
[[nodiscard]] xsimd::batch<float, A> multiplySubtract(const xsimd::batch<float, A>& a, const xsimd::batch<float, A>& b,
                                                      const xsimd::batch<float, A>& c)
{
    return xsimd::fms(a, b, c);
}
template <class A>
[[nodiscard]] xsimd::batch<double, A>
multiplySubtract(const xsimd::batch<double, A>& a, const xsimd::batch<double, A>& b, const xsimd::batch<double, A>& c)
{
    return a * b - c;
}

template <class A>
[[nodiscard]] xsimd::batch<float, A> dot(const Vec3<xsimd::batch<float, A>>& a, const Vec3<xsimd::batch<float, A>>& b)
{
    return multiplyAdd(a.x, b.x, multiplyAdd(a.y, b.y, a.z * b.z));
}

/// A number that every lane shares: see counting.h.
template <class S, class A> [[nodiscard]] S sharedNumber(const xsimd::batch<S, A>& n)
{
    alignas(64) S lanes[xsimd::batch<S, A>::size];
    n.store_aligned(lanes);
    return lanes[0];
}

/// Between two entries of a table in a straight line: see lobe_table.h.
template <class A>
[[nodiscard]] xsimd::batch<float, A> between(const float* values, const xsimd::batch<float, A>& place)
{
    using B = xsimd::batch<float, A>;
    const xsimd::batch<std::int32_t, A> first = xsimd::to_int(place);
    const B share = place - xsimd::to_float(first);
    return B::gather(values, first) * (B(1.0F) - share) + B::gather(values + 1, first) * share;
}

/// asin(x) for 0 <= x <= sqrt(1/2): x (1 + t Q(t)), t = x^2, with Q the polynomial that meets (asin(x) / x - 1) / t at
/// the eight Chebyshev points of 0 .. 1/2. Off by at most 2^-26 of the result.
template <class A> [[nodiscard]] xsimd::batch<float, A> arcsine(const xsimd::batch<float, A>& x)
{
    using B = xsimd::batch<float, A>;
    const B t = x * x;
    B Q(0.0946973496F);
    for (const float c : {-0.07972071596F, 0.06379697639F, 0.01043532597F, 0.03199023923F, 0.04453881397F,
                          0.07500252164F, 0.1666666568F})
        Q = B(c) + t * Q;
    return x + x * (t * Q);
}

/// In double each lane by itself: only the C library gives all digits of it.
template <class A> [[nodiscard]] xsimd::batch<double, A> arcsine(const xsimd::batch<double, A>& x)
{
    alignas(64) double lanes[xsimd::batch<double, A>::size];
    x.store_aligned(lanes);
    for (double& lane : lanes)
        lane = std::asin(lane);
    return xsimd::batch<double, A>::load_aligned(lanes);
}

} // namespace reflectance
