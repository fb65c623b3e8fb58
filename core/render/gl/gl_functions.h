// One context's table of GL functions, and what the driver complained about while they ran.
#pragma once

#include "core/base/result.h"
#include "core/render/headless/headless_context.h"

#include <glad/gl.h>
#include <memory>
#include <string>

namespace reflectance {

using Gl = GladGLContext;

/// Debug output of kind "error" and "undefined behaviour" is kept and becomes the Error of the call that caused it.
/// The driver holds the address of this value, so it stays where it was made.
class GlFunctions {
public:
    [[nodiscard]] static Result<std::unique_ptr<GlFunctions>> load(GetProcAddress load);
    GlFunctions(const GlFunctions&) = delete;
    GlFunctions& operator=(const GlFunctions&) = delete;
    ~GlFunctions();

    [[nodiscard]] const Gl& gl() const { return gl_; }

    /// What went wrong since the last call: the first debug message, or the error flag of drivers without debug output.
    [[nodiscard]] Result<void> complaint();

private:
    GlFunctions() = default;
    static void GLAD_API_PTR note(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                  const GLchar* message, const void* self);

    Gl gl_{};
    std::string message_;
};

} // namespace reflectance
