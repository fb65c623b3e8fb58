// A block of samples on the stack, laid out as the kernels read it.
#pragma once

#include "core/reflectance/kernel.h"

#include <array>
#include <cstddef>

namespace reflectance {

/// Large enough that a kernel call costs nothing, small enough that a block stays in the first-level cache.
inline constexpr std::size_t blockSize = 256;

template <class T> struct Vec3Column {
    alignas(64) std::array<T, blockSize> x, y, z;

    /// Rounds once, from double to T.
    void set(std::size_t i, const Vec3d& v)
    {
        x[i] = static_cast<T>(v.x);
        y[i] = static_cast<T>(v.y);
        z[i] = static_cast<T>(v.z);
    }
    void fill(const Vec3d& v)
    {
        x.fill(static_cast<T>(v.x));
        y.fill(static_cast<T>(v.y));
        z.fill(static_cast<T>(v.z));
    }
    [[nodiscard]] Vec3<T> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    [[nodiscard]] Vec3Array<const T> read() const { return {x.data(), y.data(), z.data()}; }
    [[nodiscard]] Vec3Array<T> write() { return {x.data(), y.data(), z.data()}; }
};

template <class T> struct ShadeBlock {
    Vec3Column<T> N, L, V, I, sum;
    alignas(64) std::array<T, blockSize> lightDisc;

    [[nodiscard]] ShadeBatch<T> batch(std::size_t count)
    {
        return {count, N.read(), L.read(), V.read(), I.read(), lightDisc.data(), sum.write()};
    }
    [[nodiscard]] EnvironmentBatch<T> environmentBatch(std::size_t count, const Surroundings<T>& surroundings)
    {
        return {count, N.read(), V.read(), surroundings, sum.write()};
    }
};

} // namespace reflectance
