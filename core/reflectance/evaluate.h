// A model at given directions, one row at a time or many: what `eval` prints and every test of a model asks.
#pragma once

#include "core/reflectance/arithmetic.h"
#include "core/reflectance/catalogue.h"
#include "core/reflectance/observation.h"

#include <span>
#include <vector>

namespace reflectance {

/// The lecture's factor times the light, cosine included, summed over the row's lights; linear and unclamped.
/// N, L and V are normalised in double and rounded once, then everything runs in the given precision (not Glsl, which
/// belongs to the GL renderer). `measured` serves a model that looks a table up. A row whose N, L or V has no direction is black.
[[nodiscard]] std::vector<Vec3d> evaluate(const Model& model, std::span<const double> values,
                                          std::span<const Observation> rows, const Arithmetic& arithmetic,
                                          const MeasuredSurfaces& measured = {});

} // namespace reflectance
