// The lights as the shading pass reads them from a buffer texture: two texels each, see shaders/gl/arrival.glsl.
#pragma once

#include "core/illumination/light.h"
#include "core/render/gl/gl_objects.h"

#include <vector>

namespace reflectance {

/// 8 floats per light that is on and not black, in the scene's order. Directions are normalised in double.
[[nodiscard]] std::vector<float> lightTexels(const std::vector<Light>& lights);

inline constexpr std::size_t floatsPerLight = 8;

class LightBuffer {
public:
    explicit LightBuffer(const Gl& gl);

    void upload(const std::vector<float>& texels);
    void bindAsInput(int unit) const;

private:
    GlBuffer buffer_;
    GlTexture texture_;
    std::size_t capacity_ = 0; ///< floats
};

} // namespace reflectance
