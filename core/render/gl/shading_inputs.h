// Everything the shading pass depends on, and nothing else: two scenes with equal inputs have the same linear picture
// of the same samples. What the scene does not require is left out, so changing it shades nothing again.
#pragma once

#include "core/render/gl/gl_shading.h"
#include "core/scene/requirements.h"
#include "core/scene/scene.h"

#include <memory>
#include <vector>

namespace reflectance {

struct ShadingInputs {
    Requirements requirements;
    std::vector<double> values; ///< the required model's parameters
    std::vector<float> lights;  ///< see lightTexels
    Environment environment;    ///< None unless required
    Background background;
    std::shared_ptr<const MeasuredTable> table; ///< null unless required
    GlShading how = {};

    friend bool operator==(const ShadingInputs&, const ShadingInputs&) = default;
};

[[nodiscard]] ShadingInputs shadingInputsOf(const Scene& scene, const GlShading& how = {});

} // namespace reflectance
