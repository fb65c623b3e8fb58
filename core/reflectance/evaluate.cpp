#include "core/reflectance/evaluate.h"

#include "core/base/check.h"
#include "core/math/angle.h"
#include "core/reflectance/shade_block.h"

namespace reflectance {
namespace {

/// Collects (row, light) pairs until a block is full, evaluates them in T and adds them to their rows in T.
template <class T> class PairEvaluator {
public:
    PairEvaluator(const Kernel<T>& kernel, std::span<const double> values, const MeasuredSurface<T>& measured,
                  std::size_t rows)
        : kernel_(kernel), values_(values), measured_(measured), totals_(rows)
    {
    }

    void add(std::size_t row, const Vec3d& N, const Vec3d& V, const Vec3d& L, const ObservedLight& light)
    {
        block_.N.set(count_, N);
        block_.V.set(count_, V);
        block_.L.set(count_, L);
        block_.I.set(count_, light.I);
        block_.lightDisc[count_] = static_cast<T>(squaredChord(light.radius));
        rows_[count_] = row;
        if (++count_ == blockSize)
            flush();
    }

    [[nodiscard]] std::vector<Vec3d> totals()
    {
        flush();
        std::vector<Vec3d> result;
        result.reserve(totals_.size());
        for (const Vec3<T>& total : totals_)
            result.emplace_back(total);
        return result;
    }

private:
    void flush()
    {
        block_.sum.fill({});
        ShadeBatch<T> batch = block_.batch(count_);
        batch.measured = measured_;
        kernel_.shade(values_.data(), batch);
        for (std::size_t i = 0; i < count_; ++i)
            totals_[rows_[i]] += block_.sum[i];
        count_ = 0;
    }

    const Kernel<T>& kernel_;
    std::span<const double> values_;
    MeasuredSurface<T> measured_;
    std::vector<Vec3<T>> totals_;
    ShadeBlock<T> block_;
    std::array<std::size_t, blockSize> rows_{};
    std::size_t count_ = 0;
};

template <class T>
std::vector<Vec3d> evaluateWith(const Kernel<T>& kernel, std::span<const double> values,
                                std::span<const Observation> rows, const MeasuredSurface<T>& measured)
{
    PairEvaluator<T> evaluator(kernel, values, measured, rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const Vec3d N = normalized(rows[row].N);
        const Vec3d V = normalized(rows[row].V);
        if (N == Vec3d() || V == Vec3d())
            continue;
        for (const ObservedLight& light : rows[row].lights) {
            const Vec3d L = normalized(light.L);
            if (L != Vec3d())
                evaluator.add(row, N, V, L, light);
        }
    }
    return evaluator.totals();
}

} // namespace

std::vector<Vec3d> evaluate(const Model& model, std::span<const double> values, std::span<const Observation> rows,
                            const Arithmetic& arithmetic, const MeasuredSurfaces& measured)
{
    CHECK_EQ(values.size(), model.text.valueCount());
    CHECK_LT(static_cast<int>(arithmetic.precision), static_cast<int>(Precision::Glsl));
    const Kernels& kernels = model.with(arithmetic.lobe);
    if (arithmetic.precision == Precision::Double)
        return evaluateWith(kernels.exact, values, rows, measured.exact);
    return evaluateWith(arithmetic.precision == Precision::Float ? kernels.single : kernels.lanes, values, rows,
                        measured.single);
}

} // namespace reflectance
