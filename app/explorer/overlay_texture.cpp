#include "app/explorer/overlay_texture.h"

#include <GL/glcorearb.h>
#include <array>

namespace reflectance::explorer {

OverlayTexture::~OverlayTexture()
{
    if (remove_)
        remove_();
}

void OverlayTexture::show(int width, int height, std::span<const std::uint8_t> rgb, GetProcAddress load)
{
    const auto bind = reinterpret_cast<PFNGLBINDTEXTUREPROC>(load("glBindTexture"));
    const auto parameter = reinterpret_cast<PFNGLTEXPARAMETERIPROC>(load("glTexParameteri"));
    if (name_ == 0) {
        reinterpret_cast<PFNGLGENTEXTURESPROC>(load("glGenTextures"))(1, &name_);
        remove_ = [this, drop = reinterpret_cast<PFNGLDELETETEXTURESPROC>(load("glDeleteTextures"))] {
            drop(1, &name_);
        };
    }
    bind(GL_TEXTURE_2D, name_);
    for (const auto filter : std::array<GLenum, 2>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        parameter(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const auto wrap : std::array<GLenum, 2>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        parameter(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    reinterpret_cast<PFNGLPIXELSTOREIPROC>(load("glPixelStorei"))(GL_UNPACK_ALIGNMENT, 1);
    reinterpret_cast<PFNGLTEXIMAGE2DPROC>(load("glTexImage2D"))(GL_TEXTURE_2D, 0, GL_RGB8, width, height, 0, GL_RGB,
                                                                GL_UNSIGNED_BYTE, rgb.data());
    bind(GL_TEXTURE_2D, 0);
}

} // namespace reflectance::explorer
