// From where something is to be seen back to what makes it: the light whose highlight peaks at a point of the picture, the
// light whose terminator runs through it; width.h has the highlight's edge. Pure functions, in double.
#pragma once

#include "core/study/grab/grasp.h"
#include "core/study/probe/probe.h"

#include <optional>

namespace reflectance {

/// Where a light's spot lies on a surface: where R meets V, or, where the model has no highlight, where the surface faces
/// the light.
enum class SpotKind { Mirrored, Facing };

/// Mirrored where, seen at 45 degrees, a light in the mirror's direction is brighter than one beside the eye.
[[nodiscard]] SpotKind spotKindOf(const Scene& scene);

/// The light moved so that its spot peaks at the point: R.V = 1 there, or N.L = 1. A point light keeps its distance from the
/// origin, or, where the surface lies beyond it, from the point. An error where the surface is seen from its edge.
[[nodiscard]] Result<Light> withSpotAt(const Light& light, const Vec3d& eye, const ProbedPoint& point, SpotKind kind);

/// The light moved no farther than it takes for N.L = 0 at the point; a point light keeps its distance from the origin where
/// that is possible. An error where the light stands straight above the point.
[[nodiscard]] Result<Light> withTerminatorAt(const Light& light, const ProbedPoint& point);

/// What lies within `reach` pixels of a point of the picture: the edge of a spot (where it has half its height), the
/// spot itself, or a terminator, in this order; of several lights the one that is brightest there. Lights that are off have
/// nothing to hold.
[[nodiscard]] std::optional<Grasp> graspAt(const Scene& scene, const ProbedPoint& point, double reach);

/// Where the spot of a light is seen, within a pixel; none where no visible part of the object shows it.
[[nodiscard]] std::optional<ProbedPoint> spotIn(const Scene& scene, const Light& light, int width, int height);

} // namespace reflectance
