#include "core/render/gl/light_texels.h"

#include <algorithm>

namespace reflectance {

std::vector<float> lightTexels(const std::vector<Light>& lights)
{
    std::vector<float> texels;
    for (const Light& light : lights) {
        if (!light.on || light.intensity == Vec3d())
            continue;
        const bool isPoint = light.kind == LightKind::Point;
        const Vec3f place(isPoint ? light.position : normalized(light.direction));
        const Vec3f I(light.intensity);
        texels.insert(texels.end(), {place.x, place.y, place.z, isPoint ? 1.0F : 0.0F, I.x, I.y, I.z,
                                     static_cast<float>(discOf(light))});
    }
    return texels;
}

LightBuffer::LightBuffer(const Gl& gl) : buffer_(gl), texture_(gl) {}

void LightBuffer::upload(const std::vector<float>& texels)
{
    const Gl& gl = buffer_.gl();
    const auto bytes = static_cast<GLsizeiptr>(texels.size() * sizeof(float));
    gl.BindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    if (texels.size() > capacity_ || capacity_ == 0) {
        capacity_ = std::max(texels.size(), floatsPerLight * 64);
        gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(capacity_ * sizeof(float)), nullptr, GL_DYNAMIC_DRAW);
        gl.BindTexture(GL_TEXTURE_BUFFER, texture_.id());
        gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.id());
    }
    gl.BufferSubData(GL_TEXTURE_BUFFER, 0, bytes, texels.data());
}

void LightBuffer::bindAsInput(int unit) const
{
    buffer_.gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    buffer_.gl().BindTexture(GL_TEXTURE_BUFFER, texture_.id());
}

} // namespace reflectance
