// Nanoseconds per shading: the textbook's pow against the shipped kernels, the special forms against the general one, a
// yardstick written by hand, and Oren-Nayar against Lambert. One light, n not an integer. The exponent is opaque to the
// compiler: seen as a constant, 37.5 becomes multiplications and a root.
#include "core/reflectance/catalogue.h"
#include "core/reflectance/kernel_tables.h"
#include "core/study/bench/direction_rows.h"
#include "tests/benchmarks/yardstick.h"

#include <benchmark/benchmark.h>
#include <cstring>

namespace reflectance {
namespace {

/// The textbook: pow(max(0, R.V), n), one row after the other.
template <class T> void shadeByPow(const double* values, const ShadeBatch<T>& batch)
{
    Mat3<T> K;
    for (int row = 0; row < 3; ++row)
        K.rows[row] = Vec3<T>(Vec3d(values[3 * row], values[3 * row + 1], values[3 * row + 2]));
    const T ks = static_cast<T>(values[9]);
    const T n = static_cast<T>(values[12]);
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

template <class T> using Shade = KernelCode<ShadeBatch<T>>;

template <class T>
void run(benchmark::State& state, const ParameterValues& named, const std::string& model, Shade<T> shade)
{
    DirectionRows<T> rows(static_cast<std::size_t>(state.range(0)));
    std::vector<double> values = flatValues((*findModel(model))->text, named);
    benchmark::DoNotOptimize(values.data());
    for (auto _ : state) {
        shade(values.data(), rows.batch());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

const ParameterValues hybridValues{{"n", {37.5}}};

const Model& modelNamed(const char* id)
{
    return **findModel(id);
}

template <class T>
void add(const std::string& name, const ParameterValues& values, const std::string& model, Shade<T> shade)
{
    // 2^13 rows stay in the second-level cache, 2^18 do not.
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run<T>(state, values, model, shade); })
        ->Arg(1 << 13)
        ->Arg(1 << 18);
}

const bool registered = [] {
    const Model& hybrid = modelNamed("hybrid");
    const Kernels& oneKs = hybrid.with(SpecialForm{MatrixForm::Full, ColorForm::One, false});
    add<double>("hybrid/pow/double", hybridValues, "hybrid", Shade<double>(shadeByPow<double>));
    add<float>("hybrid/pow/float", hybridValues, "hybrid", Shade<float>(shadeByPow<float>));
    add<double>("hybrid/kernel/double", hybridValues, "hybrid", hybrid.exact.shade);
    add<float>("hybrid/kernel/float", hybridValues, "hybrid", hybrid.single.shade);
    add<float>("hybrid/kernel/simd", hybridValues, "hybrid", hybrid.lanes.shade);
    add<float>("hybrid/kernel/sse2", hybridValues, "hybrid",
               lanesKernelsSse2().models[&hybrid - catalogue().data()].shade);
    add<double>("hybrid/one_ks/double", hybridValues, "hybrid", oneKs.exact.shade);
    add<float>("hybrid/one_ks/simd", hybridValues, "hybrid", oneKs.lanes.shade);
    if (std::strcmp(lanesName(), "avx2") == 0)
        add<float>("hybrid/yardstick/avx2", hybridValues, "hybrid", Shade<float>(yardstickHybrid));
    for (const LobeFormFacts& facts : lobeForms().subspan(1)) // a whole n, for squarings
        add<float>("hybrid/" + std::string(facts.name) + "/simd", {{"n", {37.0}}}, "hybrid",
                   hybrid.with(facts.form).lanes.shade);
    add<float>("lambert/simd", {}, "lambert", modelNamed("lambert").lanes.shade);
    add<float>("lambert_color/simd", {}, "lambert_color", modelNamed("lambert_color").lanes.shade);
    add<float>("oren_nayar/simd", {}, "oren_nayar", modelNamed("oren_nayar").lanes.shade);
    return true;
}();

} // namespace
} // namespace reflectance
