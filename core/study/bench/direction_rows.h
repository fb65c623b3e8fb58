// Directions to time kernels on: many more than a cache holds, and every other viewer near the highlight.
#pragma once

#include "core/math/lobe.h"
#include "core/reflectance/kernel.h"

#include <random>
#include <vector>

namespace reflectance {

/// Sixteen arrays: N, L, V, I, lightDisc and sum. Lights stand above the surface. The same rows every time.
/// The arrays begin at different places of a page: where all begin at one, the processor's first cache has room for eight of
/// them, and what is timed is that.
template <class T> class DirectionRows {
public:
    explicit DirectionRows(std::size_t count) : count_(count), numbers_(16 * stride())
    {
        std::mt19937 engine(7);
        std::normal_distribution<double> gauss;
        const auto direction = [&] { return normalized({gauss(engine), gauss(engine), gauss(engine)}); };
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3d N = direction();
            Vec3d L = direction();
            if (dot(N, L) < 0.0)
                L = -L;
            const Vec3d V = i % 2 == 0 ? direction() : normalized(mirrored(N, L) + 0.1 * direction());
            set(0, i, N);
            set(3, i, L);
            set(6, i, V);
            set(9, i, {1.0, 0.9, 0.8});
        }
    }

    [[nodiscard]] std::size_t count() const { return count_; }

    [[nodiscard]] ShadeBatch<T> batch(const MeasuredSurface<T>& measured = {})
    {
        return {count(), at(0), at(3), at(6), at(9), column(12), {column(13), column(14), column(15)}, measured};
    }

private:
    /// Five lines of the cache beyond whole pages.
    [[nodiscard]] std::size_t stride() const
    {
        constexpr std::size_t page = 4096 / sizeof(T), lines = 320 / sizeof(T);
        return (count_ + page - 1) / page * page + lines;
    }
    [[nodiscard]] T* column(std::size_t i) { return numbers_.data() + i * stride(); }
    void set(std::size_t first, std::size_t i, const Vec3d& v)
    {
        column(first)[i] = static_cast<T>(v.x);
        column(first + 1)[i] = static_cast<T>(v.y);
        column(first + 2)[i] = static_cast<T>(v.z);
    }
    [[nodiscard]] Vec3Array<const T> at(std::size_t first)
    {
        return {column(first), column(first + 1), column(first + 2)};
    }

    std::size_t count_;
    std::vector<T> numbers_;
};

} // namespace reflectance
