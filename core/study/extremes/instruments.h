// What the hazards are run on: the catalogue, something that evaluates models and something that renders. Tests hand in
// others, to see that a fault is found.
#pragma once

#include "core/image/image.h"
#include "core/reflectance/catalogue.h"
#include "core/reflectance/observation.h"
#include "core/reflectance/precision.h"
#include "core/render/settings.h"
#include "core/scene/scene.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace reflectance {

class GlRenderer;

struct Instruments {
    const std::vector<Model>* models = nullptr;
    std::function<Result<std::vector<Vec3d>>(const Model&, std::span<const double> values, std::span<const Observation>,
                                             Precision)>
        evaluate;
    std::function<Result<Image>(const Scene&, const RenderSettings&, Precision)> render;
    std::string whyNoGlsl; ///< empty where GLSL runs
};

/// The program's own. Without a renderer `whyNoGlsl` says why; a renderer must outlive the instruments, its context
/// current.
[[nodiscard]] Instruments programInstruments(GlRenderer* gl, std::string whyNoGlsl = {});

} // namespace reflectance
