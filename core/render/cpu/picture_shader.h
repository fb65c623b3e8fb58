// Shades samples into pixels with the kernel that a scene asks for, in one number type.
#pragma once

#include "core/base/check.h"
#include "core/reflectance/viewer.h"
#include "core/render/cpu/sample_shader.h"
#include "core/scene/requirements.h"

#include <algorithm>
#include <span>

namespace reflectance {

/// Sums the radiance of each pixel's samples, pixels first .. first + sums.size(), in T.
template <class T>
void sumSamples(const ViewSamples& samples, const SampleShader<T>& shader, std::size_t firstPixel,
                std::span<Vec3<T>> sums)
{
    ShadeBlock<T> block;
    const auto offsets = std::span(samples.firstOfPixel).subspan(firstPixel, sums.size() + 1);
    std::size_t pixel = 0;
    for (std::size_t first = offsets.front(); first < offsets.back(); first += blockSize) {
        const std::size_t count = std::min<std::size_t>(blockSize, offsets.back() - first);
        shader.shade(samples, first, count, block);
        for (std::size_t i = 0; i < count; ++i) {
            while (first + i >= offsets[pixel + 1])
                ++pixel;
            sums[pixel] += block.sum[i];
        }
    }
}

/// Calls work(shader), with the shader of the scene's kernel in double or float, which is what `arithmetic` asks for.
template <class Work> void withShader(const Scene& scene, const Arithmetic& arithmetic, const Work& work)
{
    CHECK_LT(static_cast<int>(arithmetic.precision), static_cast<int>(Precision::Glsl));
    const RequiredModel required = requiredSurface(scene, arithmetic);
    const bool otherLobe = arithmetic.lobe != LobeForm::Conditioned && required.model->text.usesLobe;
    const Kernels& kernels = otherLobe ? required.model->with(arithmetic.lobe) : required.model->with(required.form);
    const bool viewer = required.form.facing || looksAtViewer(required.model->text);
    if (arithmetic.precision == Precision::Double)
        work(SampleShader<double>(scene, kernels.exact, required.values, viewer));
    else
        work(SampleShader<float>(scene, arithmetic.precision == Precision::Float ? kernels.single : kernels.lanes,
                                 required.values, viewer));
}

} // namespace reflectance
