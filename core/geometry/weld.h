// Which vertices lie at the same position.
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace reflectance {

/// For every position the index of the first one equal to it (0 and -0 are equal; a NaN equals nothing).
[[nodiscard]] std::vector<std::uint32_t> firstAtSamePlace(std::span<const Vec3d> positions, int threads = 1);

} // namespace reflectance
