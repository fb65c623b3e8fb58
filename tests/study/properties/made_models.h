// Models made by hand, each with one fault or one wrong word, to see whether `check` notices.
#pragma once

#include "core/reflectance/catalogue.h"

namespace reflectance::test {

/// What the faults are planted in: kd I max(0, N.L), and its text.
struct Sound {
    static Vec3d shade(const double* values, const Vec3d& N, const Vec3d& L, const Vec3d&, const Vec3d& I)
    {
        const double cosine = dot(N, L);
        return (cosine > 0.0 ? values[0] * cosine : 0.0) * I;
    }
};

template <class Shade, class T> void shadeAll(const double* values, const ShadeBatch<T>& batch)
{
    for (std::size_t i = 0; i < batch.count; ++i) {
        const Vec3d N(batch.N[i]);
        const Vec3d value = Shade::shade(values, N, Vec3d(batch.L[i]), Vec3d(batch.V[i]), Vec3d(batch.I[i]));
        batch.sum.x[i] += static_cast<T>(value.x);
        batch.sum.y[i] += static_cast<T>(value.y);
        batch.sum.z[i] += static_cast<T>(value.z);
    }
}

/// A model with one parameter kd, 0 to 1, that computes Shade. It declares to be reciprocal and passive.
template <class Shade> Model madeModel()
{
    constexpr const char* text = "//! name Made\n"
                                 "//! reciprocal yes\n"
                                 "//! passive yes\n"
                                 "uniform float kd = 0.5;\n"
                                 "//: slider 0 .. 1\n"
                                 "//: legal 0 .. inf\n"
                                 "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return kd * I; }\n";
    Model model;
    model.text = *parseModelText("made", text, {});
    model.exact.shade = shadeAll<Shade, double>;
    model.single.shade = shadeAll<Shade, float>;
    model.lanes.shade = shadeAll<Shade, float>;
    return model;
}

} // namespace reflectance::test
