// Nanoseconds per shading of the hybrid model, full K, one light, n not an integer: the textbook's pow against the
// shipped kernels. The exponent is opaque to the compiler: seen as a constant, 37.5 becomes multiplications and a root.
#include "core/math/lobe.h"
#include "core/reflectance/catalogue.h"
#include "core/reflectance/kernel_tables.h"

#include <benchmark/benchmark.h>
#include <random>
#include <vector>

namespace reflectance {
namespace {

/// Sixteen arrays: N, L, V, I, lightDisc and sum.
template <class T> struct Rows {
    std::vector<T> numbers[16];

    explicit Rows(std::size_t count)
    {
        for (auto& array : numbers)
            array.resize(count);
        std::mt19937 engine(7);
        std::normal_distribution<double> gauss;
        const auto direction = [&] { return normalized({gauss(engine), gauss(engine), gauss(engine)}); };
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3d N = direction();
            Vec3d L = direction();
            if (dot(N, L) < 0.0)
                L = -L;
            // Every other viewer stands near the highlight.
            const Vec3d V = i % 2 == 0 ? direction() : normalized(mirrored(N, L) + 0.1 * direction());
            set(0, i, N);
            set(3, i, L);
            set(6, i, V);
            set(9, i, {1.0, 0.9, 0.8});
        }
    }

    [[nodiscard]] ShadeBatch<T> batch()
    {
        return {numbers[0].size(),
                at(0),
                at(3),
                at(6),
                at(9),
                numbers[12].data(),
                {numbers[13].data(), numbers[14].data(), numbers[15].data()}};
    }

private:
    void set(std::size_t column, std::size_t i, const Vec3d& v)
    {
        numbers[column][i] = static_cast<T>(v.x);
        numbers[column + 1][i] = static_cast<T>(v.y);
        numbers[column + 2][i] = static_cast<T>(v.z);
    }
    [[nodiscard]] Vec3Array<const T> at(std::size_t column) const
    {
        return {numbers[column].data(), numbers[column + 1].data(), numbers[column + 2].data()};
    }
};

std::vector<double> hybridValues()
{
    std::vector<double> values = flatValues((*findModel("hybrid"))->text, {{"n", {37.5}}});
    benchmark::DoNotOptimize(values.data());
    return values;
}

/// The textbook: pow(max(0, R.V), n), one row after the other.
template <class T> void shadeByPow(const double* values, const ShadeBatch<T>& batch)
{
    Mat3<T> K;
    for (int row = 0; row < 3; ++row)
        K.rows[row] = Vec3<T>(Vec3d(values[3 * row], values[3 * row + 1], values[3 * row + 2]));
    const T ks = static_cast<T>(values[9]);
    const T n = static_cast<T>(values[10]);
    for (std::size_t i = 0; i < batch.count; ++i) {
        const T cosine = dot(batch.N[i], batch.L[i]);
        if (!(cosine > T(0)))
            continue;
        const Vec3<T> R = mirrored(batch.N[i], batch.L[i]);
        const T lobe = std::pow(std::max(T(0), dot(R, batch.V[i])), n);
        const Vec3<T> value = cosine * (K * batch.I[i]) + (ks * lobe) * batch.I[i];
        batch.sum.x[i] += value.x;
        batch.sum.y[i] += value.y;
        batch.sum.z[i] += value.z;
    }
}

template <class T> void run(benchmark::State& state, void (*shade)(const double*, const ShadeBatch<T>&))
{
    Rows<T> rows(static_cast<std::size_t>(state.range(0)));
    const std::vector<double> values = hybridValues();
    for (auto _ : state) {
        shade(values.data(), rows.batch());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

const Model& hybrid()
{
    return **findModel("hybrid");
}

void powDouble(benchmark::State& state)
{
    run<double>(state, shadeByPow<double>);
}
void powFloat(benchmark::State& state)
{
    run<float>(state, shadeByPow<float>);
}
void kernelDouble(benchmark::State& state)
{
    run<double>(state, hybrid().exact.shade);
}
void kernelFloat(benchmark::State& state)
{
    run<float>(state, hybrid().single.shade);
}
void kernelSimd(benchmark::State& state)
{
    run<float>(state, hybrid().lanes.shade);
}
void kernelSse2(benchmark::State& state)
{
    run<float>(state, lanesKernelsSse2()[&hybrid() - catalogue().data()].shade);
}

// 2^13 rows stay in the second-level cache, 2^18 do not.
BENCHMARK(powDouble)->Arg(1 << 13)->Arg(1 << 18);
BENCHMARK(powFloat)->Arg(1 << 13)->Arg(1 << 18);
BENCHMARK(kernelDouble)->Arg(1 << 13)->Arg(1 << 18);
BENCHMARK(kernelFloat)->Arg(1 << 13)->Arg(1 << 18);
BENCHMARK(kernelSimd)->Arg(1 << 13)->Arg(1 << 18);
BENCHMARK(kernelSse2)->Arg(1 << 13)->Arg(1 << 18);

} // namespace
} // namespace reflectance
