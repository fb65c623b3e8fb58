// One maker per kind of micro-surface. Internal to microSurface.
#pragma once

#include "core/study/goniometer/micro_surface.h"
#include "core/study/goniometer/surface_words.h"

namespace reflectance {

[[nodiscard]] Result<std::vector<Patch>> makeFlat(std::string_view words);
[[nodiscard]] Result<std::vector<Patch>> makeVGrooves(std::string_view text);
[[nodiscard]] Result<std::vector<Patch>> makeGaussian(std::string_view text);
[[nodiscard]] Result<std::vector<Patch>> makeScratches(std::string_view text);
[[nodiscard]] Result<std::vector<Patch>> patchesFromPicture(const std::string& path, std::string_view words);
[[nodiscard]] Result<std::vector<Patch>> patchesFromMesh(const std::string& path, std::string_view words);

} // namespace reflectance
