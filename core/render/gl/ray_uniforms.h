// The camera's rays, as shaders/gl/rays.glsl reads them.
#pragma once

#include "core/geometry/camera.h"
#include "core/render/gl/gl_program.h"
#include "core/render/settings.h"

namespace reflectance {

/// Computed in double, rounded once. The program must be in use.
void setRays(const GlProgram& program, const Camera& camera, const RenderSettings& settings);

} // namespace reflectance
