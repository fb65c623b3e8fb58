// From shader texts to linked programs; where a folder is given, by way of the driver's binaries that were kept there.
#pragma once

#include "core/base/result.h"
#include "core/render/gl/gl_objects.h"
#include "core/render/gl/shader_source.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace reflectance {

/// A kept binary counts only for the same texts under the same driver, version included, and only if that driver takes it;
/// whatever else lies in the folder is linked anew and replaced. A folder that cannot be read or written is as good as none.
class ProgramLinker {
public:
    /// Keeps binaries in `folder`, which is made when first needed; an empty name, or a driver without binaries: nowhere.
    explicit ProgramLinker(const Gl& gl, std::filesystem::path folder = {});

    [[nodiscard]] Result<GlProgramObject> link(const ShaderSource& vertex, const ShaderSource& fragment);

    [[nodiscard]] const Gl& gl() const { return *gl_; }
    /// Programs that came from the folder instead of the compiler.
    [[nodiscard]] std::uint64_t loaded() const { return loaded_; }

    /// At most so many files are kept; the oldest go first.
    static constexpr std::size_t largestNumberOfFiles = 256;

private:
    [[nodiscard]] std::string keyOf(const ShaderSource& vertex, const ShaderSource& fragment) const;
    [[nodiscard]] std::filesystem::path fileOf(const std::string& key) const;
    [[nodiscard]] bool load(const GlProgramObject& program, const std::string& key) const;
    void keep(const GlProgramObject& program, const std::string& key) const;

    const Gl* gl_;
    std::filesystem::path folder_; ///< empty: nothing is kept
    std::uint64_t loaded_ = 0;
};

} // namespace reflectance
