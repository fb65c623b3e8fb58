// What one evaluation of a model costs on this machine.
#pragma once

#include "core/reflectance/arithmetic.h"
#include "core/reflectance/catalogue.h"

#include <optional>

namespace reflectance {

/// Nanoseconds per pair of directions and light: the best of several rounds over a block that stays in the first-level cache.
/// Not for Glsl.
[[nodiscard]] double shadingCost(const Model& model, const std::vector<double>& flat, const Arithmetic& arithmetic);

/// Machine instructions for the same; nothing where the system does not count them.
[[nodiscard]] std::optional<double> shadingInstructions(const Model& model, const std::vector<double>& flat,
                                                        const Arithmetic& arithmetic);

} // namespace reflectance
