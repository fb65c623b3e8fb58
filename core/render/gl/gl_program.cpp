#include "core/render/gl/gl_program.h"

namespace reflectance {

Result<GlProgram> GlProgram::link(ProgramLinker& linker, const ShaderSource& vertex, const ShaderSource& fragment)
{
    auto program = linker.link(vertex, fragment);
    if (!program)
        return program.error();
    return GlProgram(*std::move(program));
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
