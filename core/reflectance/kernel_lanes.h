// The loop around a model text in SIMD lanes B of an instruction set. Included by the kernels_<set>*.cpp only, each compiled
// for its own processor; nothing here may be called elsewhere.
#pragma once

#include "core/math/lanes.h"
#include "core/reflectance/kernel_loops.h"

namespace reflectance {

/// What is left of a batch when whole registers are done, as a batch of one register: its last row fills it up.
template <class S, std::size_t W> class PaddedRest {
public:
    /// The last rows, less than W of them.
    PaddedRest(std::size_t first, std::size_t count) : first_(first), count_(count) {}

    [[nodiscard]] S* copied(const S* from)
    {
        S* to = numbers_[used_++];
        for (std::size_t i = 0; i < W; ++i)
            to[i] = from[first_ + (i < count_ ? i : count_ - 1)];
        return to;
    }
    template <class T> [[nodiscard]] Vec3Array<T> copied(const Vec3Array<T>& from)
    {
        return {copied(from.x), copied(from.y), copied(from.z)};
    }
    void giveBack(const Vec3Array<S>& sum, const Vec3Array<S>& to) const
    {
        for (std::size_t i = 0; i < count_; ++i) {
            to.x[first_ + i] = sum.x[i];
            to.y[first_ + i] = sum.y[i];
            to.z[first_ + i] = sum.z[i];
        }
    }

private:
    alignas(64) S numbers_[16][W] = {};
    std::size_t used_ = 0, first_, count_;
};

template <class B, class S> Vec3<B> loaded(const Vec3Array<const S>& from, std::size_t i)
{
    return {B::load_unaligned(from.x + i), B::load_unaligned(from.y + i), B::load_unaligned(from.z + i)};
}

template <class B, class S> void addLanes(S* to, const B& value)
{
    (B::load_unaligned(to) + value).store_unaligned(to);
}

template <class B, class S> void addLanes(const Vec3Array<S>& sum, std::size_t i, const Vec3<B>& value)
{
    addLanes(sum.x + i, value.x);
    addLanes(sum.y + i, value.y);
    addLanes(sum.z + i, value.z);
}

/// Calls a scalar environment for each lane.
template <class B> Vec3<B> surroundingsLaneByLane(const void* data, const Vec3<B>& direction)
{
    using S = typename B::value_type;
    const auto& scalar = *static_cast<const Surroundings<S>*>(data);
    alignas(64) S in[3][B::size];
    alignas(64) S out[3][B::size] = {};
    direction.x.store_aligned(in[0]);
    direction.y.store_aligned(in[1]);
    direction.z.store_aligned(in[2]);
    for (std::size_t i = 0; i < B::size && scalar.radiance; ++i) {
        const Vec3<S> radiance = scalar.radiance(scalar.environment, {in[0][i], in[1][i], in[2][i]});
        out[0][i] = radiance.x;
        out[1][i] = radiance.y;
        out[2][i] = radiance.z;
    }
    return {B::load_aligned(out[0]), B::load_aligned(out[1]), B::load_aligned(out[2])};
}

/// Looks each lane up by itself.
template <class B>
Vec3<B> measuredLaneByLane(const void* data, const Vec3<B>& N, const Vec3<B>& L, const Vec3<B>& V, const Vec3<B>& I)
{
    using S = typename B::value_type;
    const auto& scalar = *static_cast<const MeasuredSurface<S>*>(data);
    alignas(64) S lanes[12][B::size];
    const Vec3<B>* const vectors[] = {&N, &L, &V, &I};
    for (std::size_t v = 0; v < 4; ++v) {
        vectors[v]->x.store_aligned(lanes[3 * v]);
        vectors[v]->y.store_aligned(lanes[3 * v + 1]);
        vectors[v]->z.store_aligned(lanes[3 * v + 2]);
    }
    for (std::size_t i = 0; i < B::size; ++i) {
        const auto at = [&](std::size_t v) {
            return Vec3<S>(lanes[3 * v][i], lanes[3 * v + 1][i], lanes[3 * v + 2][i]);
        };
        const Vec3<S> value = scalar(at(0), at(1), at(2), at(3));
        lanes[0][i] = value.x;
        lanes[1][i] = value.y;
        lanes[2][i] = value.z;
    }
    return {B::load_aligned(lanes[0]), B::load_aligned(lanes[1]), B::load_aligned(lanes[2])};
}

/// The whole registers of a batch. Not inlined, so that there is one place that calls the model, and all of it is inlined
/// there; the batch is copied, so that writing sums is known to leave its pointers alone.
template <class Model, class B, class S>
[[gnu::noinline]] void shadeRegisters(const double* values, const MeasuredSurface<S>& measured, ShadeBatch<S> batch)
{
    Model model(values);
    model.measured = {measuredLaneByLane<B>, &measured};
    for (std::size_t i = 0; i + B::size <= batch.count; i += B::size) {
        model.lightDisc = B::load_unaligned(batch.lightDisc + i);
        addLanes(
            batch.sum, i,
            model.shade(loaded<B>(batch.N, i), loaded<B>(batch.L, i), loaded<B>(batch.V, i), loaded<B>(batch.I, i)));
    }
}

template <class Model, class B, class S> void shadeInLanes(const double* values, const ShadeBatch<S>& batch)
{
    shadeRegisters<Model, B>(values, batch.measured, batch);
    if (const std::size_t left = batch.count % B::size; left > 0) {
        PaddedRest<S, B::size> rest(batch.count - left, left);
        const ShadeBatch<S> padded{B::size,
                                   rest.copied(batch.N),
                                   rest.copied(batch.L),
                                   rest.copied(batch.V),
                                   rest.copied(batch.I),
                                   rest.copied(batch.lightDisc),
                                   rest.copied(batch.sum)};
        shadeRegisters<Model, B>(values, batch.measured, padded);
        rest.giveBack(padded.sum, batch.sum);
    }
}

template <class Model, class B, class S>
[[gnu::noinline]] void seeRegisters(const double* values, const Surroundings<S>& seen, EnvironmentBatch<S> batch)
{
    Model model(values);
    model.surroundings = {surroundingsLaneByLane<B>, &seen};
    for (std::size_t i = 0; i + B::size <= batch.count; i += B::size)
        addLanes(batch.sum, i, model.shadeEnvironment(loaded<B>(batch.N, i), loaded<B>(batch.V, i)));
}

template <class Model, class B, class S> void environmentInLanes(const double* values, const EnvironmentBatch<S>& batch)
{
    seeRegisters<Model, B>(values, batch.surroundings, batch);
    if (const std::size_t left = batch.count % B::size; left > 0) {
        PaddedRest<S, B::size> rest(batch.count - left, left);
        const EnvironmentBatch<S> padded{
            B::size, rest.copied(batch.N), rest.copied(batch.V), {}, rest.copied(batch.sum)};
        seeRegisters<Model, B>(values, batch.surroundings, padded);
        rest.giveBack(padded.sum, batch.sum);
    }
}

template <class Model, class B> constexpr Kernel<typename B::value_type> makeKernel()
{
    using S = typename B::value_type;
    if constexpr (seesEnvironment<Model, B>)
        return {shadeInLanes<Model, B, S>, environmentInLanes<Model, B, S>};
    else
        return {shadeInLanes<Model, B, S>, nullptr};
}

} // namespace reflectance
