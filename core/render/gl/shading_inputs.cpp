#include "core/render/gl/shading_inputs.h"

#include "core/render/gl/light_texels.h"

namespace reflectance {

ShadingInputs shadingInputsOf(const Scene& scene, const GlShading& how)
{
    const Arithmetic arithmetic(Precision::Glsl, how.lobe, how.specialised);
    ShadingInputs inputs{requirementsOf(scene, arithmetic),
                         requiredSurface(scene, arithmetic).values,
                         lightTexels(shiningLights(scene)),
                         scene.environment,
                         scene.background,
                         nullptr,
                         how};
    inputs.how.lobe = inputs.requirements.lobe; // a model without a lobe has the same picture in every form of it
    if (inputs.requirements.table)
        inputs.table = scene.surface.table;
    const bool seen = inputs.requirements.environment || inputs.requirements.environmentBackground;
    if (!seen) {
        inputs.environment = Environment();
        inputs.environment.kind = EnvironmentKind::None;
    }
    if (scene.background.kind == BackgroundKind::Environment) // a black one is the plain colour black
        inputs.background.color = Vec3d();
    return inputs;
}

} // namespace reflectance
