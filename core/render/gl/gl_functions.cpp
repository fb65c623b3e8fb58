#define GLAD_GL_IMPLEMENTATION
#include "core/render/gl/gl_functions.h"

#include "core/base/text.h"

namespace reflectance {
namespace {

const char* nameOfError(GLenum error)
{
    switch (error) {
    case GL_OUT_OF_MEMORY:
        return "out of memory; use fewer samples or --backend cpu";
    case GL_INVALID_ENUM:
        return "invalid enum";
    case GL_INVALID_VALUE:
        return "invalid value";
    case GL_INVALID_OPERATION:
        return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "invalid framebuffer operation";
    default:
        return "unknown error";
    }
}

} // namespace

Result<std::unique_ptr<GlFunctions>> GlFunctions::load(GetProcAddress load)
{
    std::unique_ptr<GlFunctions> functions(new GlFunctions);
    const int version = gladLoadGLContext(&functions->gl_, load);
    if (version < GLAD_MAKE_VERSION(3, 3))
        return Error{version == 0 ? "no OpenGL context is current"
                                  : "OpenGL " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                                        std::to_string(GLAD_VERSION_MINOR(version)) +
                                        " is too old, 3.3 is needed; use --backend cpu"};
    const Gl& gl = functions->gl_;
    if (gl.KHR_debug) {
        gl.Enable(GL_DEBUG_OUTPUT);
        gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        gl.DebugMessageCallback(note, functions.get());
    }
    return functions;
}

GlFunctions::~GlFunctions()
{
    if (gl_.KHR_debug)
        gl_.DebugMessageCallback(nullptr, nullptr);
}

void GLAD_API_PTR GlFunctions::note(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
                                    const void* self)
{
    auto& functions = *static_cast<GlFunctions*>(const_cast<void*>(self)); // NOLINT(*-const-cast): GL's signature
    const bool matters = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR;
    if (matters && functions.message_.empty())
        functions.message_ = trimmed(message);
}

Result<void> GlFunctions::complaint()
{
    const GLenum flag = gl_.GetError();
    while (gl_.GetError() != GL_NO_ERROR) {
    }
    std::string message;
    message.swap(message_);
    if (message.empty() && flag != GL_NO_ERROR)
        message = nameOfError(flag);
    if (!message.empty())
        return Error{"OpenGL: " + message};
    return {};
}

} // namespace reflectance
