#include "core/render/gl/render_target.h"

namespace reflectance {
namespace {

/// The layout that glTexImage2D wants to hear for a format, though it is given no data.
struct Transfer {
    GLenum format, type;
};

Transfer transferOf(GLenum format)
{
    switch (format) {
    case GL_R32UI:
        return {GL_RED_INTEGER, GL_UNSIGNED_INT};
    case GL_RGBA8:
        return {GL_RGBA, GL_UNSIGNED_BYTE};
    default:
        return {GL_RGBA, GL_FLOAT};
    }
}

std::uint64_t bytesPerTexel(GLenum format)
{
    switch (format) {
    case GL_RGBA32F:
        return 16;
    case GL_RGBA16F:
        return 8;
    default:
        return 4;
    }
}

} // namespace

RenderTarget::RenderTarget(const Gl& gl, std::vector<GLenum> formats, WithDepth depth)
    : framebuffer_(gl), formats_(std::move(formats))
{
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    std::vector<GLenum> attachments;
    for (std::size_t i = 0; i < formats_.size(); ++i) {
        textures_.emplace_back(gl);
        attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
        gl.BindTexture(GL_TEXTURE_2D, textures_[i].id());
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachments[i], GL_TEXTURE_2D, textures_[i].id(), 0);
    }
    gl.DrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
    if (depth == WithDepth::Yes) {
        const GlRenderbuffer& buffer = depth_.emplace_back(gl);
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.id());
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffer.id());
        depthName_ = buffer.id();
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void RenderTarget::resize(int width, int height)
{
    const Gl& gl = framebuffer_.gl();
    for (std::size_t i = 0; i < formats_.size(); ++i) {
        const Transfer transfer = transferOf(formats_[i]);
        gl.BindTexture(GL_TEXTURE_2D, textures_[i].id());
        gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(formats_[i]), width, height, 0, transfer.format,
                      transfer.type, nullptr);
    }
    for (const GlRenderbuffer& buffer : depth_) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.id());
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    }
    width_ = width;
    height_ = height;
}

std::uint64_t RenderTarget::bytes() const
{
    std::uint64_t perTexel = depth_.size() * sizeof(float);
    for (const GLenum format : formats_)
        perTexel += bytesPerTexel(format);
    return perTexel * static_cast<std::uint64_t>(width_) * static_cast<std::uint64_t>(height_);
}

void RenderTarget::shareDepthOf(const RenderTarget& other)
{
    const Gl& gl = framebuffer_.gl();
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, other.depthName_);
    depthName_ = other.depthName_;
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void RenderTarget::bind() const
{
    framebuffer_.gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    framebuffer_.gl().Viewport(0, 0, width_, height_);
}

void RenderTarget::bindForReading(int texture) const
{
    framebuffer_.gl().BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    framebuffer_.gl().ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(texture));
}

void RenderTarget::bindAsInput(int texture, int unit) const
{
    framebuffer_.gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    framebuffer_.gl().BindTexture(GL_TEXTURE_2D, this->texture(texture));
}

} // namespace reflectance
