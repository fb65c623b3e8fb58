// What one evaluation of a model costs on this machine.
#pragma once

#include "core/reflectance/arithmetic.h"
#include "core/reflectance/catalogue.h"
#include "core/reflectance/required_model.h"

#include <optional>

namespace reflectance {

/// Nanoseconds per pair of directions and light: the best of several rounds over a block that stays in the first-level cache.
/// Not for Glsl.
[[nodiscard]] double shadingCost(const Model& model, const std::vector<double>& flat, const Arithmetic& arithmetic);

/// The same of what a renderer runs: the form that the values require, or another form of the lobe.
[[nodiscard]] double shadingCost(const RequiredModel& required, const Arithmetic& arithmetic);

/// Machine instructions for the same; nothing where the system does not count them.
[[nodiscard]] std::optional<double> shadingInstructions(const RequiredModel& required, const Arithmetic& arithmetic);

} // namespace reflectance
