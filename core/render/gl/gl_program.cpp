#include "core/render/gl/gl_program.h"

#include "core/base/text.h"

namespace reflectance {
namespace {

template <class Shader> std::string shaderLog(const Gl& gl, const Shader& shader)
{
    GLint length = 0;
    gl.GetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl.GetShaderInfoLog(shader.id(), length, nullptr, log.data());
    return log;
}

template <class Shader> Result<Shader> compiled(const Gl& gl, const ShaderSource& source)
{
    Shader shader(gl);
    const char* text = source.text.data();
    const auto length = static_cast<GLint>(source.text.size());
    gl.ShaderSource(shader.id(), 1, &text, &length);
    gl.CompileShader(shader.id());
    GLint success = GL_FALSE;
    gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &success);
    if (success != GL_TRUE)
        return compilerError(shaderLog(gl, shader), source);
    return shader;
}

std::string linkLog(const Gl& gl, GLuint program)
{
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl.GetProgramInfoLog(program, length, nullptr, log.data());
    return std::string(trimmed(log.c_str()));
}

} // namespace

Result<GlProgram> GlProgram::link(const Gl& gl, const ShaderSource& vertex, const ShaderSource& fragment)
{
    const auto vertexShader = compiled<GlVertexShader>(gl, vertex);
    if (!vertexShader)
        return vertexShader.error();
    const auto fragmentShader = compiled<GlFragmentShader>(gl, fragment);
    if (!fragmentShader)
        return fragmentShader.error();
    GlProgramObject program(gl);
    gl.AttachShader(program.id(), vertexShader.value().id());
    gl.AttachShader(program.id(), fragmentShader.value().id());
    gl.LinkProgram(program.id());
    GLint success = GL_FALSE;
    gl.GetProgramiv(program.id(), GL_LINK_STATUS, &success);
    if (success != GL_TRUE)
        return Error{"the shader does not link: " + linkLog(gl, program.id()), fragment.files.back()};
    gl.DetachShader(program.id(), vertexShader.value().id());
    gl.DetachShader(program.id(), fragmentShader.value().id());
    return GlProgram(std::move(program));
}

GLint GlProgram::location(const char* name) const
{
    return program_.gl().GetUniformLocation(program_.id(), name);
}

void GlProgram::set(const char* name, int value) const
{
    program_.gl().Uniform1i(location(name), value);
}

void GlProgram::set(const char* name, float value) const
{
    program_.gl().Uniform1f(location(name), value);
}

void GlProgram::set(const char* name, const std::array<float, 2>& value) const
{
    program_.gl().Uniform2fv(location(name), 1, value.data());
}

void GlProgram::set(const char* name, const Vec3d& value) const
{
    const Vec3f v(value);
    program_.gl().Uniform3f(location(name), v.x, v.y, v.z);
}

void GlProgram::set(const char* name, std::span<const float> value) const
{
    program_.gl().Uniform1fv(location(name), static_cast<GLsizei>(value.size()), value.data());
}

void GlProgram::setRows(const char* name, const float* nine) const
{
    program_.gl().UniformMatrix3fv(location(name), 1, GL_TRUE, nine);
}

void GlProgram::setColumns(const char* name, const float* sixteen) const
{
    program_.gl().UniformMatrix4fv(location(name), 1, GL_FALSE, sixteen);
}

Result<const GlProgram*> GlProgramCache::find(const std::string& key, const std::function<Result<GlProgram>()>& link)
{
    const auto known = programs_.find(key);
    if (known != programs_.end())
        return &known->second;
    auto program = link();
    if (!program)
        return program.error();
    return &programs_.emplace(key, *std::move(program)).first->second;
}

} // namespace reflectance
