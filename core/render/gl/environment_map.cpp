#include "core/render/gl/environment_map.h"

#include "core/base/check.h"

namespace reflectance {

EnvironmentMap::EnvironmentMap(const Gl& gl) : texture_(gl)
{
    gl.BindTexture(GL_TEXTURE_2D, texture_.id());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

Result<void> EnvironmentMap::show(const std::shared_ptr<const Image>& picture)
{
    CHECK_EQ(picture != nullptr, true);
    if (picture == picture_)
        return {};
    const Gl& gl = texture_.gl();
    GLint limit = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (picture->width > limit || picture->height > limit)
        return Error{"an environment of " + std::to_string(picture->width) + "x" + std::to_string(picture->height) +
                     " is larger than this driver's textures (" + std::to_string(limit) +
                     "); use a smaller picture or --backend cpu"};
    gl.BindTexture(GL_TEXTURE_2D, texture_.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, picture->width, picture->height, 0, GL_RGB, GL_FLOAT,
                  picture->rgb.data());
    picture_ = picture;
    uploadedBytes_ += picture->rgb.size() * sizeof(float);
    return {};
}

void EnvironmentMap::bindAsInput(int unit) const
{
    texture_.gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    texture_.gl().BindTexture(GL_TEXTURE_2D, texture_.id());
}

} // namespace reflectance
