// SIMD lanes as a number type for the model texts. One arithmetic, any instruction set: A is an xsimd architecture.
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <limits>
#include <xsimd/xsimd.hpp>

namespace reflectance {

template <class S, class A> struct ScalarOf<xsimd::batch<S, A>> {
    using type = S;
};

template <class S, class A>
[[nodiscard]] xsimd::batch<S, A> gate(const xsimd::batch<S, A>& condition, const xsimd::batch<S, A>& value)
{
    const xsimd::batch<S, A> zero(S(0));
    return xsimd::select(condition > zero, value, zero);
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

/// exp(y) for y <= 0; 0 below the smallest normal number: denormals triple the time of a kernel.
template <class S, class A> [[nodiscard]] xsimd::batch<S, A> expOrZero(const xsimd::batch<S, A>& y)
{
    using B = xsimd::batch<S, A>;
    const B smallest(std::log(std::numeric_limits<S>::min()) + S(0.01));
    return xsimd::select(y >= smallest, xsimd::exp(xsimd::max(y, smallest)), B(S(0)));
}

/// The conditioned lobe of lobe.h without a branch: one log and one exp of a blended base.
/// For R.V > 1/2 the base is u = 1-x and log1p(-x) = log(u) + ((1-u)-x)/u, the second term giving back what forming u
/// rounded away.
template <class S, class A>
[[nodiscard]] xsimd::batch<S, A> lobe(const Vec3<xsimd::batch<S, A>>& R, const Vec3<xsimd::batch<S, A>>& V,
                                      const xsimd::batch<S, A>& n)
{
    using B = xsimd::batch<S, A>;
    const B zero(S(0));
    const B one(S(1));
    const B half(S(0.5));
    const B cosine = dot(R, V);
    const Vec3<B> chord = R - V;
    const B x = half * dot(chord, chord);
    const auto near = cosine > half;
    const B rounded = one - x;
    const B base = xsimd::select(near, rounded, cosine);
    const B correction = xsimd::select(near, ((one - rounded) - x) / base, zero);
    const B positive = xsimd::max(base, B(std::numeric_limits<S>::min()));
    return xsimd::select(cosine > zero, expOrZero(n * (xsimd::log(positive) + correction)), zero);
}

} // namespace reflectance
