// Shades blocks of surface samples: sets up N, L, V, I as the kernels read them and calls the model once per light.
#pragma once

#include "core/reflectance/shade_block.h"
#include "core/render/view_samples.h"
#include "core/scene/scene.h"

#include <vector>

namespace reflectance {

template <class T> class SampleShader {
public:
    /// The kernel and its values are the scene's, or what the scene requires of them; the scene must outlive the shader.
    /// A kernel that does not look at the viewer gets no V.
    SampleShader(const Scene& scene, const Kernel<T>& kernel, std::vector<double> values, bool looksAtViewer);

    /// Radiance of samples first .. first + count, count <= blockSize, into block.sum.
    void shade(const ViewSamples& samples, std::size_t first, std::size_t count, ShadeBlock<T>& block) const;

private:
    /// A light as a block of samples sees it. Those of a directional light are the same for every block.
    struct LightColumns {
        Vec3Column<T> L, I;
        alignas(64) std::array<T, blockSize> lightDisc;
    };

    void load(const ViewSamples& samples, std::size_t first, std::size_t count, ShadeBlock<T>& block) const;
    void addLight(const LightColumns& light, std::size_t count, ShadeBlock<T>& block) const;

    const Kernel<T>& kernel_;
    std::vector<double> values_;
    std::vector<LightColumns> directional_;
    std::vector<Light> point_;
    const Scene& scene_;
    MeasuredSurface<T> measured_;
    bool paintsHoles_ = false, looksAtViewer_ = true;
    Surroundings<T> surroundings_; ///< without a function where the model or the scene has no environment
};

extern template class SampleShader<double>;
extern template class SampleShader<float>;

} // namespace reflectance
