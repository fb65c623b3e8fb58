// What share of the light each model sends on, over the light's angle, with the error of the quadrature.
#pragma once

#include "core/render/progress.h"
#include "core/study/curves.h"

#include <optional>
#include <vector>

namespace reflectance {

/// Directional albedo at twelve angles from 0 to 88 degrees; the bars are how far two quadratures lie apart. A guide marks
/// where as much leaves as arrives. A mirror sees a light of a small disc. Nothing where `progress` was cancelled; its
/// share done is set.
[[nodiscard]] std::optional<Chart> albedoOver(const std::vector<NamedSurface>& surfaces, Shown shown,
                                              Progress& progress);

} // namespace reflectance
