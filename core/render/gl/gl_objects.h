// GL names with an owner: made with the object, deleted with it, moved but never copied.
#pragma once

#include "core/render/gl/gl_functions.h"

#include <utility>

namespace reflectance {

/// Kind::make(gl) gives a name, Kind::destroy(gl, name) returns it.
template <class Kind> class GlObject {
public:
    explicit GlObject(const Gl& gl) : gl_(&gl), id_(Kind::make(gl)) {}
    GlObject(GlObject&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(gl_, other.gl_);
        std::swap(id_, other.id_);
        return *this;
    }
    ~GlObject()
    {
        if (id_ != 0)
            Kind::destroy(*gl_, id_);
    }

    [[nodiscard]] GLuint id() const { return id_; }
    [[nodiscard]] const Gl& gl() const { return *gl_; }

private:
    const Gl* gl_;
    GLuint id_;
};

namespace detail {

template <auto Gl::*Generate, auto Gl::*Delete> struct Generated {
    static GLuint make(const Gl& gl)
    {
        GLuint id = 0;
        (gl.*Generate)(1, &id);
        return id;
    }
    static void destroy(const Gl& gl, GLuint id) { (gl.*Delete)(1, &id); }
};

struct ProgramKind {
    static GLuint make(const Gl& gl) { return gl.CreateProgram(); }
    static void destroy(const Gl& gl, GLuint id) { gl.DeleteProgram(id); }
};

template <GLenum Stage> struct ShaderKind {
    static GLuint make(const Gl& gl) { return gl.CreateShader(Stage); }
    static void destroy(const Gl& gl, GLuint id) { gl.DeleteShader(id); }
};

} // namespace detail

using GlTexture = GlObject<detail::Generated<&Gl::GenTextures, &Gl::DeleteTextures>>;
using GlBuffer = GlObject<detail::Generated<&Gl::GenBuffers, &Gl::DeleteBuffers>>;
using GlFramebuffer = GlObject<detail::Generated<&Gl::GenFramebuffers, &Gl::DeleteFramebuffers>>;
using GlRenderbuffer = GlObject<detail::Generated<&Gl::GenRenderbuffers, &Gl::DeleteRenderbuffers>>;
using GlVertexArray = GlObject<detail::Generated<&Gl::GenVertexArrays, &Gl::DeleteVertexArrays>>;
using GlQuery = GlObject<detail::Generated<&Gl::GenQueries, &Gl::DeleteQueries>>;
using GlProgramObject = GlObject<detail::ProgramKind>;
using GlVertexShader = GlObject<detail::ShaderKind<GL_VERTEX_SHADER>>;
using GlFragmentShader = GlObject<detail::ShaderKind<GL_FRAGMENT_SHADER>>;

} // namespace reflectance
