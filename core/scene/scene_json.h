// A scene as JSON, and back: what scene files and saved pictures share. Internal to core/scene.
#pragma once

#include "core/scene/json_reader.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"

namespace reflectance {

inline constexpr const char* sceneSchema = "reflectance.scene";

/// How the files that a scene names are written and found.
struct ScenePaths {
    std::string folder; ///< of the file that holds the scene
    std::string folderBefore =
        {};                ///< reading: where that folder was when it was written; empty where that is not known
    bool fromRoot = false; ///< writing: every path whole, also below the folder
};

[[nodiscard]] ObjectReader::Json sceneJson(const Scene& scene, const ScenePaths& paths);

/// Over the scene that is there: what the object does not name stays.
void readScene(ObjectReader object, Scene& scene, const ScenePaths& paths);

} // namespace reflectance
