#include "core/render/gl/ray_uniforms.h"

#include "core/math/angle.h"

#include <cmath>

namespace reflectance {

void setRays(const GlProgram& program, const Camera& camera, const RenderSettings& settings)
{
    const CameraFrame frame = frameOf(camera);
    const double pixel = 2.0 * std::tan(0.5 * radians(camera.fieldOfView)) / settings.height;
    const double sample = pixel / settings.samplesPerAxis;
    program.set("cornerRay", -0.5 * pixel * (settings.width * frame.right + settings.height * frame.up) - frame.back);
    program.set("rayStepX", sample * frame.right);
    program.set("rayStepY", sample * frame.up);
}

} // namespace reflectance
