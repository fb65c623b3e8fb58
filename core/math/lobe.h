// The lobe (R.V)^n in its conditioned form, and the other primitives that model texts may call.
//
// pow(dot(R,V), n) loses n*eps: with n = 1e6 a float picture is 13 % wrong. Here x = |R-V|^2 / 2 = 1 - R.V is formed
// without cancellation and the lobe is exp(n log1p(-x)) where R.V > 1/2; below, 1-x would cancel and the plain dot
// is right. 0 wherever R.V <= 0, at every n, n = 0 included. SIMD lanes have their own text in lanes.h, GLSL in
// shaders/prelude.glsl.
#pragma once

#include "core/math/vec.h"

namespace reflectance {

[[nodiscard]] inline double lobe(const Vec3d& R, const Vec3d& V, double n)
{
    const double cosine = dot(R, V);
    if (!(cosine > 0.0))
        return 0.0;
    if (cosine <= 0.5)
        return std::pow(cosine, n);
    const Vec3d chord = R - V;
    return std::exp(n * std::log1p(-0.5 * dot(chord, chord)));
}

[[nodiscard]] inline float lobe(const Vec3f& R, const Vec3f& V, float n)
{
    const float cosine = dot(R, V);
    if (!(cosine > 0.0F))
        return 0.0F;
    if (cosine <= 0.5F)
        return std::pow(cosine, n);
    const Vec3f chord = R - V;
    return std::exp(n * std::log1p(-0.5F * dot(chord, chord)));
}

/// value where condition > 0, else 0: the open gate of N.L > 0.
[[nodiscard]] inline double gate(double condition, double value) { return condition > 0.0 ? value : 0.0; }
[[nodiscard]] inline float gate(float condition, float value) { return condition > 0.0F ? value : 0.0F; }

template <class T> [[nodiscard]] Vec3<T> gate(const T& condition, const Vec3<T>& value)
{
    return {gate(condition, value.x), gate(condition, value.y), gate(condition, value.z)};
}

/// 2N(N.A) - A: A mirrored about N.
template <class T> [[nodiscard]] Vec3<T> mirrored(const Vec3<T>& N, const Vec3<T>& A)
{
    return (lit<T>(2.0) * dot(N, A)) * N - A;
}

} // namespace reflectance
