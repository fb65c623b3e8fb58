// A model of the user's own: a text under the rules of shaders/README.md that the program meets while running. GL compiles
// it as it is; on the CPU it is walked (core/reflectance/walked), in double and in float.
#pragma once

#include "core/reflectance/catalogue.h"

#include <memory>

namespace reflectance {

/// The text with kernels that walk it. Its lanes are scalar float.
[[nodiscard]] Result<Model> walkedModel(ModelText text);

/// A model from the bytes of a file. Its id is the file's name in small letters, digits and "_", with "own_" before it where the
/// catalogue has that id; its name, where the text gives none, is that of the file. The error names file and line.
[[nodiscard]] Result<std::shared_ptr<const Model>> ownModel(const std::string& path, std::string_view bytes);

/// The same, read from the disk.
[[nodiscard]] Result<std::shared_ptr<const Model>> readOwnModel(const std::string& path);

} // namespace reflectance
