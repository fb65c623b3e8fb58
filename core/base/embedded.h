// Files that travel inside the program: shaders and the default meshes. Nothing is looked up beside the binary.
#pragma once

#include <span>
#include <string_view>

namespace reflectance {

struct EmbeddedFile {
    std::string_view name; ///< "reflectance/phong.glsl", "meshes/mug.obj"
    std::string_view bytes;
};

/// Every file under shaders/ (named from there) and the meshes ("meshes/NAME").
[[nodiscard]] std::span<const EmbeddedFile> embeddedFiles();

/// The bytes of a file that the program itself carries; a name that was not embedded is a programming error.
[[nodiscard]] std::string_view embeddedText(std::string_view name);

} // namespace reflectance
