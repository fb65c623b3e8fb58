// Polygons to triangles: fans for convex polygons, ear clipping for the others.
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace reflectance {

/// Triangles over the polygon's own corners 0 .. n-1, keeping its orientation. Their areas add up to the polygon's area
/// where it is planar and does not cross itself; a hole joined by a bridge edge stays a hole. A polygon that crosses
/// itself gives some n-2 triangles. 100 000 corners take tenths of a second; what needs far more work is fanned.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Vec3d> polygon);

} // namespace reflectance
