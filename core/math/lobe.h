// The lobe (R.V)^n in its conditioned form, and the other primitives that model texts may call.
//
// pow(dot(R,V), n) loses n*eps: with n = 1e6 a float picture is 13 % wrong. Here x = |R-V|^2 / 2 = 1 - R.V is formed
// without cancellation and the lobe is exp(n log1p(-x)) where R.V > 1/2; below, 1-x would cancel and the plain dot
// is right. 0 wherever R.V <= 0, at every n, n = 0 included, and below the smallest normal number. One text for double,
// float and SIMD lanes; GLSL's stands in shaders/lobe/conditioned.glsl.
#pragma once

#include "core/math/exponentials.h"
#include "core/math/vec.h"

namespace reflectance {

/// value where condition > 0, else 0: the open gate of N.L > 0.
[[nodiscard]] inline double gate(double condition, double value)
{
    return condition > 0.0 ? value : 0.0;
}
[[nodiscard]] inline float gate(float condition, float value)
{
    return condition > 0.0F ? value : 0.0F;
}

/// log2 of 1 - |R - V|^2 / 2 near the peak, of the plain cosine away from it.
template <class T> [[nodiscard, gnu::always_inline]] inline T lobe(const Vec3<T>& R, const Vec3<T>& V, const T& n)
{
    const T cosine = dot(R, V);
    const Vec3<T> chord = R - V;
    const T below = lit<T>(-0.5) * dot(chord, chord);
    const T base = choose(cosine > lit<T>(0.5), lit<T>(1.0) + below, cosine);
    return gate(cosine, exp2OrZero(n * log2Of(base, below)));
}

template <class T> [[nodiscard]] Vec3<T> gate(const T& condition, const Vec3<T>& value)
{
    return {gate(condition, value.x), gate(condition, value.y), gate(condition, value.z)};
}

/// 2N(N.A) - A: A mirrored about N.
template <class T> [[nodiscard]] Vec3<T> mirrored(const Vec3<T>& N, const Vec3<T>& A)
{
    const T twice = lit<T>(2.0) * dot(N, A);
    return {multiplySubtract(twice, N.x, A.x), multiplySubtract(twice, N.y, A.y), multiplySubtract(twice, N.z, A.z)};
}

} // namespace reflectance
