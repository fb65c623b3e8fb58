// A linked GLSL program and its uniforms, and a cache of them.
#pragma once

#include "core/math/vec.h"
#include "core/render/gl/program_linker.h"

#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>

namespace reflectance {

class GlProgram {
public:
    [[nodiscard]] static Result<GlProgram> link(ProgramLinker& linker, const ShaderSource& vertex,
                                                const ShaderSource& fragment);

    void use() const { program_.gl().UseProgram(program_.id()); }

    // For the program in use. A name that the compiler found unused is no error.
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const std::array<float, 2>& value) const;
    void set(const char* name, const Vec3d& value) const;           ///< rounded once
    void set(const char* name, std::span<const float> value) const; ///< float[]
    void setRows(const char* name, const float* nine) const;        ///< mat3, row by row
    void setColumns(const char* name, const float* sixteen) const;  ///< mat4, column by column

private:
    explicit GlProgram(GlProgramObject program) : program_(std::move(program)) {}
    [[nodiscard]] GLint location(const char* name) const;

    GlProgramObject program_;
};

/// Programs by key: each is linked once, when first asked for.
class GlProgramCache {
public:
    [[nodiscard]] Result<const GlProgram*> find(const std::string& key, const std::function<Result<GlProgram>()>& link);
    [[nodiscard]] std::size_t size() const { return programs_.size(); }

private:
    std::map<std::string, GlProgram> programs_;
};

} // namespace reflectance
