// What surrounds a model text on the C++ side: the quantities that belong to the light or the scene, not to the surface.
#pragma once

#include "core/math/directions.h"
#include "core/math/lobe.h"
#include "core/math/shading_language.h"
#include "core/reflectance/kernel.h"

namespace reflectance {

/// The part of a model's frame that gives it its lobe; the other forms stand in lobe_kernels.h.
template <class T> struct ConditionedLobe {
    /// Always part of the loop that shades: as a call of its own, through memory, it costs a third of the kernel's time.
    [[nodiscard, gnu::always_inline]] static inline T lobe(const Vec3<T>& R, const Vec3<T>& V, const T& n)
    {
        return reflectance::lobe(R, V, n);
    }
};

template <class T> struct Frame {
    T lightDisc{};                  ///< (2 sin(a/2))^2 for the light's angular radius a; 0 for a light without extent
    Surroundings<T> surroundings{}; ///< what a mirror sees
    MeasuredSurface<T> measured{};  ///< what a table looks up

    /// 1 where V lies inside the light's disc about R, else 0. The disc is open: radius 0 contains nothing.
    [[nodiscard]] T insideLight(const Vec3<T>& R, const Vec3<T>& V) const
    {
        const Vec3<T> chord = R - V;
        return gate(lightDisc - dot(chord, chord), lit<T>(1.0));
    }

    [[nodiscard]] Vec3<T> environment(const Vec3<T>& direction) const { return surroundings(direction); }

    [[nodiscard]] Vec3<T> tableAt(const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V, const Vec3<T>& I) const
    {
        return measured(N, L, V, I);
    }
};

} // namespace reflectance
