// A picture that shaders draw into and later passes read: textures of one size behind a framebuffer object.
#pragma once

#include "core/render/gl/gl_objects.h"

#include <cstdint>
#include <vector>

namespace reflectance {

enum class WithDepth { No, Yes };

class RenderTarget {
public:
    /// One texture per format, GL_RGBA32F, GL_RGBA16F, GL_RGBA8 or GL_R32UI. `resize` must follow.
    RenderTarget(const Gl& gl, std::vector<GLenum> formats, WithDepth depth);

    /// Allocates anew; contents are undefined until drawn.
    void resize(int width, int height);

    /// Tests against the depths that `other` has now, its own or shared, from now on; they must live as long and be at
    /// least as large.
    void shareDepthOf(const RenderTarget& other);

    /// Draws go here from now on, to the whole of it.
    void bind() const;
    /// glReadPixels reads this texture from now on.
    void bindForReading(int texture) const;
    /// texelFetch at this unit reads this texture from now on.
    void bindAsInput(int texture, int unit) const;

    [[nodiscard]] GLuint texture(int index) const { return textures_[static_cast<std::size_t>(index)].id(); }
    [[nodiscard]] std::size_t textures() const { return textures_.size(); }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] std::uint64_t bytes() const; ///< of the textures and the depth

private:
    GlFramebuffer framebuffer_;
    std::vector<GLenum> formats_;
    std::vector<GlTexture> textures_;
    std::vector<GlRenderbuffer> depth_; ///< its own: one or none
    GLuint depthName_ = 0;              ///< of the depths it tests against; 0: none
    int width_ = 0;
    int height_ = 0;
};

} // namespace reflectance
