// The lobe of one exponent as a table, and the form that reads it: the C++ side of shaders/lobe/table.glsl.
#pragma once

#include "core/math/counting.h"
#include "core/math/lobe.h"
#include "core/math/shading_language.h"

#include <array>
#include <type_traits>

namespace reflectance {

inline constexpr int lobeTableSteps = 256;

/// (1 - s^2)^n at equal steps of s = sqrt(1 - R.V), from 0 to where no more than exp(-12) of the peak is left.
template <class S> struct LobeTable {
    std::array<S, lobeTableSteps + 1> values{};
    S scale{}; ///< steps per unit of s
};

[[nodiscard]] LobeTable<double> makeLobeTable(double n);

/// The table of n. Each thread keeps its latest: kernels are called for blocks of one picture, and all share its n.
template <class S> [[nodiscard]] const LobeTable<S>& lobeTableFor(double n);
extern template const LobeTable<double>& lobeTableFor<double>(double n);
extern template const LobeTable<float>& lobeTableFor<float>(double n);

/// Between two entries in a straight line, place in 0 .. 256. Lanes have their own in lanes.h.
template <class S> [[nodiscard]] S between(const S* values, S place)
{
    const auto first = static_cast<std::size_t>(place);
    const S share = place - static_cast<S>(first);
    return values[first] * (S(1) - share) + values[first + 1] * share;
}

/// As a part of a model: see Frame.
template <class T> struct TableLobe {
    using S = typename ScalarOf<T>::type;
    const LobeTable<S>* table = nullptr;

    [[nodiscard]] T lobe(const Vec3<T>& R, const Vec3<T>& V, const T& n)
    {
        if (table == nullptr) // n stays while the model lives
            table = &lobeTableFor<S>(static_cast<double>(sharedNumber(n)));
        const Vec3<T> chord = R - V;
        const T s = sqrt(lit<T>(0.5) * dot(chord, chord));
        return gate(dot(R, V), between(table->values.data(), min(s * T(table->scale), lit<T>(255.999))));
    }
};

} // namespace reflectance
