// `render --lens`: the digits that an arithmetic keeps, as a picture, instead of the view itself.
#pragma once

#include "core/image/notes.h"
#include "core/render/headless/headless_context.h"
#include "core/render/settings.h"
#include "core/scene/scene.h"
#include "core/study/lens/lens.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace reflectance::cli {

/// "float", "half", "simd" or "glsl".
[[nodiscard]] LensKind lensNamed(std::string_view name);

/// Glsl draws in a context of this kind. Watched by LongWork.
[[nodiscard]] Result<LensMap> lensOf(const Scene& scene, const RenderSettings& settings, LensKind kind,
                                     ContextKind context);

/// Writes the map as a PNG, in the lens' colours.
[[nodiscard]] Result<void> writeLens(const std::string& path, const LensMap& map, const Notes& notes);

[[nodiscard]] nlohmann::ordered_json lensReport(LensKind kind, const LensMap& map);

} // namespace reflectance::cli
