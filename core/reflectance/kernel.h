// A kernel evaluates one model over many directions: structure of arrays in, radiance added to arrays out.
#pragma once

#include "core/math/vec.h"

#include <cstddef>
#include <type_traits>

namespace reflectance {

/// Three arrays, one per component.
template <class T> struct Vec3Array {
    T* x = nullptr;
    T* y = nullptr;
    T* z = nullptr;

    [[nodiscard]] Vec3<std::remove_const_t<T>> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// A measured surface as a function of unit directions: f(L, V) I in 1/sr, 0 in its holes; without a function it is black.
template <class T> struct MeasuredSurface {
    Vec3<T> (*lookUp)(const void* table, const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V,
                      const Vec3<T>& I) = nullptr;
    const void* table = nullptr;

    Vec3<T> operator()(const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V, const Vec3<T>& I) const
    {
        return lookUp ? lookUp(table, N, L, V, I) : Vec3<T>();
    }
};

/// The same surface for every arithmetic.
struct MeasuredSurfaces {
    MeasuredSurface<double> exact;
    MeasuredSurface<float> single;

    template <class T> [[nodiscard]] const MeasuredSurface<T>& in() const
    {
        if constexpr (std::is_same_v<T, double>)
            return exact;
        else
            return single;
    }
};

/// Unit vectors N, L, V, light I as it arrives at the surface, and the light's disc (see Frame::lightDisc).
template <class T> struct ShadeBatch {
    std::size_t count = 0;
    Vec3Array<const T> N, L, V, I;
    const T* lightDisc = nullptr;
    Vec3Array<T> sum;                 ///< the model's value is added here
    MeasuredSurface<T> measured = {}; ///< what a table looks up
};

/// The environment as a function of the direction away from the surface; without a function it is black.
template <class T> struct Surroundings {
    Vec3<T> (*radiance)(const void* environment, const Vec3<T>& direction) = nullptr;
    const void* environment = nullptr;

    Vec3<T> operator()(const Vec3<T>& direction) const
    {
        return radiance ? radiance(environment, direction) : Vec3<T>();
    }
};

template <class T> struct EnvironmentBatch {
    std::size_t count = 0;
    Vec3Array<const T> N, V;
    Surroundings<T> surroundings;
    Vec3Array<T> sum;
};

/// What a kernel runs: compiled code, or a text that is walked as it stands.
template <class Batch> class KernelCode {
public:
    using Compiled = void (*)(const double* values, const Batch& batch);
    using Walked = void (*)(const void* text, const double* values, const Batch& batch);

    constexpr KernelCode() = default;
    constexpr KernelCode(std::nullptr_t) {}
    constexpr KernelCode(Compiled compiled) : compiled_(compiled) {}
    constexpr KernelCode(Walked walked, const void* text) : walked_(walked), text_(text) {}

    void operator()(const double* values, const Batch& batch) const
    {
        if (compiled_)
            compiled_(values, batch);
        else
            walked_(text_, values, batch);
    }
    constexpr explicit operator bool() const { return compiled_ || walked_; }
    friend constexpr bool operator==(const KernelCode& code, std::nullptr_t) { return !code; }

private:
    Compiled compiled_ = nullptr;
    Walked walked_ = nullptr;
    const void* text_ = nullptr; ///< lives as long as the model
};

/// `values` is the model's flat list of parameter values, always double; the kernel rounds them once to its type.
template <class T> struct Kernel {
    KernelCode<ShadeBatch<T>> shade;
    KernelCode<EnvironmentBatch<T>> environment; ///< none: ignores it
};

} // namespace reflectance
