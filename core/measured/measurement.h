// Anything that was measured, whatever its form: a function from two directions to a BRDF, and where it comes from.
#pragma once

#include "core/measured/rgl.h"
#include "core/measured/scattered.h"
#include "core/measured/table.h"

#include <memory>
#include <variant>

namespace reflectance {

/// A grid; RGL's adaptive parameterisation; or samples at scattered angles. Each is evaluated exactly as its format means.
using Measurement = std::variant<Table, RglBrdf, ScatteredBrdf>;

[[nodiscard]] const Provenance& provenanceOf(const Measurement& measurement);
[[nodiscard]] std::size_t channelsOf(const Measurement& measurement);

/// f(L, V) as the matrix that a light's colour is multiplied with, in 1/sr. L and V are unit vectors about N = (0,0,1).
/// Nothing in holes, and where one of them is not above the surface.
[[nodiscard]] std::optional<Mat3d> brdfAt(const Measurement& measurement, const Vec3d& L, const Vec3d& V);

} // namespace reflectance
