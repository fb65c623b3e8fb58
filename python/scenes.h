// A scene as callers name it.
#pragma once

#include "core/base/text.h"
#include "core/scene/scene_file.h"
#include "python/arrays.h"

namespace reflectance::python {

/// A scene file's name, the JSON text of a scene, or "" for the clay mug.
[[nodiscard]] inline Scene sceneFrom(const std::string& text)
{
    if (text.empty())
        return defaultScene();
    return unwrapped(trimmed(text).starts_with("{") ? parseScene(text, "", "") : loadScene(text));
}

} // namespace reflectance::python
