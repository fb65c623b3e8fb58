// The loop around a model text in SIMD lanes of the instruction set A. Included by the kernels_<set>.cpp only, each
// compiled for its own processor; nothing here may be called elsewhere.
#pragma once

#include "core/math/lanes.h"
#include "core/reflectance/kernel_loops.h"

namespace reflectance {

/// What is left of an array when whole registers are done is padded in here: W numbers per array.
template <std::size_t W> struct PaddedTail {
    alignas(64) float numbers[16][W] = {};
    std::size_t used = 0;

    const float* copied(const float* from, std::size_t count)
    {
        float* to = numbers[used++];
        for (std::size_t i = 0; i < W; ++i)
            to[i] = from[i < count ? i : count - 1];
        return to;
    }
    Vec3Array<const float> copied(const Vec3Array<const float>& from, std::size_t first, std::size_t count)
    {
        return {copied(from.x + first, count), copied(from.y + first, count), copied(from.z + first, count)};
    }
};

template <class B> Vec3<B> loaded(const Vec3Array<const float>& from, std::size_t i)
{
    return {B::load_unaligned(from.x + i), B::load_unaligned(from.y + i), B::load_unaligned(from.z + i)};
}

template <class B> void addLanes(float* to, const B& value)
{
    (B::load_unaligned(to) + value).store_unaligned(to);
}

template <class B> void addLanes(const Vec3Array<float>& sum, std::size_t i, const Vec3<B>& value)
{
    addLanes(sum.x + i, value.x);
    addLanes(sum.y + i, value.y);
    addLanes(sum.z + i, value.z);
}

/// Adds the first `count` lanes.
template <class B>
void addSomeLanes(const Vec3Array<float>& sum, std::size_t first, std::size_t count, const Vec3<B>& value)
{
    alignas(64) float lanes[3][B::size];
    value.x.store_aligned(lanes[0]);
    value.y.store_aligned(lanes[1]);
    value.z.store_aligned(lanes[2]);
    for (std::size_t i = 0; i < count; ++i) {
        sum.x[first + i] += lanes[0][i];
        sum.y[first + i] += lanes[1][i];
        sum.z[first + i] += lanes[2][i];
    }
}

/// Calls a scalar environment for each lane.
template <class B> Vec3<B> surroundingsLaneByLane(const void* data, const Vec3<B>& direction)
{
    const auto& scalar = *static_cast<const Surroundings<float>*>(data);
    alignas(64) float in[3][B::size];
    alignas(64) float out[3][B::size] = {};
    direction.x.store_aligned(in[0]);
    direction.y.store_aligned(in[1]);
    direction.z.store_aligned(in[2]);
    for (std::size_t i = 0; i < B::size && scalar.radiance; ++i) {
        const Vec3<float> radiance = scalar.radiance(scalar.environment, {in[0][i], in[1][i], in[2][i]});
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
    const auto& scalar = *static_cast<const MeasuredSurface<float>*>(data);
    alignas(64) float lanes[12][B::size];
    const Vec3<B>* const vectors[] = {&N, &L, &V, &I};
    for (std::size_t v = 0; v < 4; ++v) {
        vectors[v]->x.store_aligned(lanes[3 * v]);
        vectors[v]->y.store_aligned(lanes[3 * v + 1]);
        vectors[v]->z.store_aligned(lanes[3 * v + 2]);
    }
    for (std::size_t i = 0; i < B::size; ++i) {
        const auto at = [&](std::size_t v) {
            return Vec3<float>(lanes[3 * v][i], lanes[3 * v + 1][i], lanes[3 * v + 2][i]);
        };
        const Vec3<float> value = scalar(at(0), at(1), at(2), at(3));
        lanes[0][i] = value.x;
        lanes[1][i] = value.y;
        lanes[2][i] = value.z;
    }
    return {B::load_aligned(lanes[0]), B::load_aligned(lanes[1]), B::load_aligned(lanes[2])};
}

template <class Model, class B> void shadeInLanes(const double* values, const ShadeBatch<float>& batch)
{
    Model model(values);
    model.measured = {measuredLaneByLane<B>, &batch.measured};
    std::size_t i = 0;
    for (; i + B::size <= batch.count; i += B::size) {
        model.lightDisc = B::load_unaligned(batch.lightDisc + i);
        addLanes(
            batch.sum, i,
            model.shade(loaded<B>(batch.N, i), loaded<B>(batch.L, i), loaded<B>(batch.V, i), loaded<B>(batch.I, i)));
    }
    if (const std::size_t left = batch.count - i; left > 0) {
        PaddedTail<B::size> tail;
        model.lightDisc = B::load_aligned(tail.copied(batch.lightDisc + i, left));
        const auto N = tail.copied(batch.N, i, left);
        const auto L = tail.copied(batch.L, i, left);
        const auto V = tail.copied(batch.V, i, left);
        const auto I = tail.copied(batch.I, i, left);
        addSomeLanes(batch.sum, i, left,
                     model.shade(loaded<B>(N, 0), loaded<B>(L, 0), loaded<B>(V, 0), loaded<B>(I, 0)));
    }
}

template <class Model, class B> void environmentInLanes(const double* values, const EnvironmentBatch<float>& batch)
{
    Model model(values);
    model.surroundings = {surroundingsLaneByLane<B>, &batch.surroundings};
    std::size_t i = 0;
    for (; i + B::size <= batch.count; i += B::size)
        addLanes(batch.sum, i, model.shadeEnvironment(loaded<B>(batch.N, i), loaded<B>(batch.V, i)));
    if (const std::size_t left = batch.count - i; left > 0) {
        PaddedTail<B::size> tail;
        const auto N = tail.copied(batch.N, i, left);
        const auto V = tail.copied(batch.V, i, left);
        addSomeLanes(batch.sum, i, left, model.shadeEnvironment(loaded<B>(N, 0), loaded<B>(V, 0)));
    }
}

template <class Model, class B> constexpr Kernel<float> lanesKernel()
{
    if constexpr (seesEnvironment<Model, B>)
        return {shadeInLanes<Model, B>, environmentInLanes<Model, B>};
    else
        return {shadeInLanes<Model, B>, nullptr};
}

} // namespace reflectance
