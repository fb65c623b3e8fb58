// Scenes as readable JSON. Every key is optional (the default scene fills the gaps); a key that nothing reads is an
// error that names the nearest known one, so that typing mistakes surface.
#pragma once

#include "core/scene/scene.h"

#include <string>
#include <string_view>

namespace reflectance {

/// Version of the format, written as "version". Files of a newer one are refused.
inline constexpr int sceneFormatVersion = 2;

/// Reads a scene. Mesh and environment paths are relative to the scene file's folder.
[[nodiscard]] Result<Scene> loadScene(const std::string& path);

/// The scene as text; paths are written relative to `folder` where they lie below it.
[[nodiscard]] std::string sceneText(const Scene& scene, const std::string& folder);

/// Reads a scene from text; errors name `file` and the line of a syntax error.
[[nodiscard]] Result<Scene> parseScene(std::string_view text, const std::string& file, const std::string& folder);

/// Writes the scene to a temporary file and renames it. Refuses a mesh or environment whose name is not UTF-8.
[[nodiscard]] Result<void> saveScene(const Scene& scene, const std::string& path);

} // namespace reflectance
