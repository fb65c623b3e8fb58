// Polygons to triangles: fans for convex polygons, ear clipping for the others.
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace reflectance {

/// Triangles over the polygon's own corners 0 .. n-1, keeping its orientation. Their areas add up to the polygon's area
/// where it is planar and does not cross itself; the seams of a hole joined by a bridge edge are handled. A polygon that
/// crosses itself gives some n-2 triangles, never a hang: O(n log n) on usual shapes, O(n^2) at worst with a budget
/// after which the rest is fanned.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Vec3d> polygon);

} // namespace reflectance
