// The loop around a model text for one number type. Included by the kernels_*.cpp only.
#pragma once

#include "core/reflectance/kernel.h"

#include <type_traits>

namespace reflectance {

template <class Model, class T> constexpr bool seesEnvironment = requires(Model& model, const Vec3<T>& v)
{
    model.shadeEnvironment(v, v);
};

template <class T> void add(const Vec3Array<T>& sum, std::size_t i, const Vec3<T>& value)
{
    sum.x[i] += value.x;
    sum.y[i] += value.y;
    sum.z[i] += value.z;
}

template <class Model, class T> void shadeOneByOne(const double* values, const ShadeBatch<T>& batch)
{
    Model model(values);
    model.measured = batch.measured;
    for (std::size_t i = 0; i < batch.count; ++i) {
        model.lightDisc = batch.lightDisc[i];
        add(batch.sum, i, model.shade(batch.N[i], batch.L[i], batch.V[i], batch.I[i]));
    }
}

template <class Model, class T> void environmentOneByOne(const double* values, const EnvironmentBatch<T>& batch)
{
    Model model(values);
    model.surroundings = batch.surroundings;
    for (std::size_t i = 0; i < batch.count; ++i)
        add(batch.sum, i, model.shadeEnvironment(batch.N[i], batch.V[i]));
}

template <class Model, class T>
requires std::is_floating_point_v<T>
constexpr Kernel<T> makeKernel()
{
    if constexpr (seesEnvironment<Model, T>)
        return {shadeOneByOne<Model, T>, environmentOneByOne<Model, T>};
    else
        return {shadeOneByOne<Model, T>, nullptr};
}

} // namespace reflectance
