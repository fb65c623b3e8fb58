// Shading per vertex (Gouraud): the model is evaluated at the mesh's vertices and its result interpolated over the
// triangles. Cheap where pixels outnumber vertices, and wrong where a highlight is narrower than a triangle.
#pragma once

#include "core/render/cpu/cpu_renderer.h"

namespace reflectance {

/// Gouraud, Continuous Shading of Curved Surfaces, IEEE Trans. Computers C-20(6), 1971. Each side of the surface has its
/// own vertex colours, since the normal turns to the viewer's side.
[[nodiscard]] Image shadePerVertex(const ViewSamples& samples, const Scene& scene, const Arithmetic& arithmetic);

} // namespace reflectance
