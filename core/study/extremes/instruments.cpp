#include "core/study/extremes/instruments.h"

#include "core/reflectance/evaluate.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/render/gl/gl_renderer.h"

namespace reflectance {

Instruments programInstruments(GlRenderer* gl, std::string whyNoGlsl)
{
    const Error noGlsl{whyNoGlsl};
    Instruments instruments;
    instruments.models = &catalogue();
    instruments.whyNoGlsl = gl ? std::string() : std::move(whyNoGlsl);
    instruments.evaluate = [gl, noGlsl](const Model& model, std::span<const double> values,
                                        std::span<const Observation> rows,
                                        Precision precision) -> Result<std::vector<Vec3d>> {
        if (precision != Precision::Glsl)
            return evaluate(model, values, rows, precision);
        return gl ? gl->evaluate(model, values, rows) : Result<std::vector<Vec3d>>(noGlsl);
    };
    instruments.render = [gl, noGlsl](const Scene& scene, const RenderSettings& settings,
                                      Precision precision) -> Result<Image> {
        if (precision != Precision::Glsl)
            return renderOnCpu(scene, settings, precision);
        if (!gl)
            return noGlsl;
        if (const auto drawn = gl->render(scene, settings); !drawn)
            return drawn.error();
        return gl->readLinear();
    };
    return instruments;
}

} // namespace reflectance
