#include "app/explorer/screen_texture.h"

#include <GL/glcorearb.h>
#include <array>
#include <utility>

namespace reflectance::explorer {
namespace {

template <class Function> Function function(GetProcAddress load, const char* name)
{
    return reinterpret_cast<Function>(load(name));
}

} // namespace

ScreenTexture::ScreenTexture(ScreenTexture&& other) noexcept
    : load_(other.load_), enlarged_(other.enlarged_), id_(std::exchange(other.id_, 0)), width_(other.width_),
      height_(other.height_)
{
}

ScreenTexture::~ScreenTexture()
{
    if (id_ != 0)
        function<PFNGLDELETETEXTURESPROC>(load_, "glDeleteTextures")(1, &id_);
}

void ScreenTexture::show(int width, int height, std::span<const std::uint8_t> rgb)
{
    if (id_ == 0)
        function<PFNGLGENTEXTURESPROC>(load_, "glGenTextures")(1, &id_);
    const auto bind = function<PFNGLBINDTEXTUREPROC>(load_, "glBindTexture");
    bind(GL_TEXTURE_2D, id_);
    function<PFNGLPIXELSTOREIPROC>(load_, "glPixelStorei")(GL_UNPACK_ALIGNMENT, 1);
    if (width != width_ || height != height_) {
        const auto parameter = function<PFNGLTEXPARAMETERIPROC>(load_, "glTexParameteri");
        for (const auto filter : std::array<GLenum, 2>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            parameter(GL_TEXTURE_2D, filter, enlarged_ == Enlarged::Squares ? GL_NEAREST : GL_LINEAR);
        for (const auto wrap : std::array<GLenum, 2>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            parameter(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
        function<PFNGLTEXIMAGE2DPROC>(load_, "glTexImage2D")(GL_TEXTURE_2D, 0, GL_RGB8, width, height, 0, GL_RGB,
                                                             GL_UNSIGNED_BYTE, rgb.data());
        width_ = width;
        height_ = height;
    } else {
        function<PFNGLTEXSUBIMAGE2DPROC>(load_, "glTexSubImage2D")(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGB,
                                                                   GL_UNSIGNED_BYTE, rgb.data());
    }
    bind(GL_TEXTURE_2D, 0);
}

} // namespace reflectance::explorer
