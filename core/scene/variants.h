// The surfaces that a scene keeps under names: any number of them, of which any two can be A and B.
#pragma once

#include "core/scene/scene.h"

#include <cstddef>
#include <string>

namespace reflectance {

/// The variant's index, or a sentence that names the nearest one.
[[nodiscard]] Result<std::size_t> findVariant(const Scene& scene, const std::string& name);

/// Keeps a surface under a fresh name; returns its index.
std::size_t keepVariant(Scene& scene, const Surface& surface);

/// An error where the name is empty or another variant has it; the variant keeps its own then.
[[nodiscard]] Result<void> renameVariant(Scene& scene, std::size_t index, const std::string& name);

} // namespace reflectance
