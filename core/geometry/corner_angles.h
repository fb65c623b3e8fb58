// The angle of every triangle at each of its corners: the weights of smooth normals.
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/unfilled.h"

#include <span>

namespace reflectance {

/// atan2(sine, cosine) for a sine >= 0 and a cosine that are not both zero: 0 .. pi. They need not be those of one angle,
/// only in their ratio. Off by at most 3 units in the last place, without a branch and without a library.
[[nodiscard]] double angleOf(double sine, double cosine);

/// Radians, in the order of each triangle's corners. The sine is the length of a cross product and not what an arc cosine
/// would take, so that the angles of needles keep their digits (hazard H16). Every triangle has an area.
[[nodiscard]] UnfilledVector<std::array<double, 3>>
cornerAngles(std::span<const Vec3d> positions, std::span<const Mesh::Triangle> triangles, int threads = 1);

} // namespace reflectance
