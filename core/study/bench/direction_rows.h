// Directions to time kernels on: many more than a cache holds, and every other viewer near the highlight.
#pragma once

#include "core/math/lobe.h"
#include "core/reflectance/kernel.h"

#include <random>
#include <vector>

namespace reflectance {

/// Sixteen arrays: N, L, V, I, lightDisc and sum. Lights stand above the surface. The same rows every time.
template <class T> class DirectionRows {
public:
    explicit DirectionRows(std::size_t count)
    {
        for (auto& array : numbers_)
            array.resize(count);
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

    [[nodiscard]] std::size_t count() const { return numbers_[0].size(); }

    [[nodiscard]] ShadeBatch<T> batch(const MeasuredSurface<T>& measured = {})
    {
        return {count(),
                at(0),
                at(3),
                at(6),
                at(9),
                numbers_[12].data(),
                {numbers_[13].data(), numbers_[14].data(), numbers_[15].data()},
                measured};
    }

private:
    void set(std::size_t column, std::size_t i, const Vec3d& v)
    {
        numbers_[column][i] = static_cast<T>(v.x);
        numbers_[column + 1][i] = static_cast<T>(v.y);
        numbers_[column + 2][i] = static_cast<T>(v.z);
    }
    [[nodiscard]] Vec3Array<const T> at(std::size_t column) const
    {
        return {numbers_[column].data(), numbers_[column + 1].data(), numbers_[column + 2].data()};
    }

    std::vector<T> numbers_[16];
};

} // namespace reflectance
