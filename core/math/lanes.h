// SIMD lanes as a number type for the model texts. One arithmetic, any instruction set: A is an xsimd architecture.
#pragma once

#include "core/math/vec.h"

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

/// The conditioned lobe of lobe.h without a branch: one log and one exp of a blended base.
/// For R.V > 1/2 the base is u = 1-x and log1p(-x) = log(u) + ((1-u)-x)/u, the second term giving back what forming u
/// rounded away. Results below the smallest normal number become 0: denormals triple the time of the kernel.
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
    const B exponent = n * (xsimd::log(positive) + correction);
    const B smallest(std::log(std::numeric_limits<S>::min()) + S(0.01));
    const B value = xsimd::exp(xsimd::max(exponent, smallest));
    return xsimd::select((cosine > zero) && (exponent >= smallest), value, zero);
}

} // namespace reflectance
