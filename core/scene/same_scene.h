// Whether two scenes are the same, part by part.
#pragma once

#include "core/scene/scene.h"

namespace reflectance {

/// Bit for bit but for the sign of zeros. Meshes, tables and pictures are the same where they are one object, not where
/// they are equal: a comparison costs no more than the scene's own numbers.
[[nodiscard]] inline bool operator==(const Scene& a, const Scene& b)
{
    return a.meshFile == b.meshFile && a.recomputeNormals == b.recomputeNormals && a.mesh == b.mesh &&
           a.camera == b.camera && a.lights == b.lights && a.environment == b.environment &&
           a.background == b.background && a.surface == b.surface && a.other == b.other && a.sensor == b.sensor &&
           a.variants == b.variants && a.pins == b.pins;
}

} // namespace reflectance
