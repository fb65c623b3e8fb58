#include "core/reflectance/kernel_tables.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/study/bench/bench.h"
#include "core/study/bench/interleaved.h"

namespace reflectance {

Result<std::vector<FrameCost>> frameCosts(const Scene& scene, const RenderSettings& settings, GlRenderer* gl,
                                          const BenchEffort& effort, Progress& progress)
{
    std::vector<FrameCost> costs;
    std::vector<TimedWork> works;
    ViewSamples samples;
    const double sampling =
        millisecondsOf([&] { samples = sampleView(*makeRayScene(scene.mesh, settings), scene.camera, settings); });
    for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd}) {
        const std::string lanes = precision == Precision::Simd ? std::string(" (") + lanesName() + ")" : "";
        const double shading = millisecondsOf([&] { static_cast<void>(shadeSamples(samples, scene, precision)); });
        costs.push_back({std::string(nameOf(precision)) + lanes, {}, sampling + shading});
        works.emplace_back(byTheWall([&, precision] { static_cast<void>(shadeSamples(samples, scene, precision)); }));
    }
    Result<void> drawn;
    if (gl != nullptr) {
        const auto draw = [&] {
            gl->invalidateShading();
            drawn = gl->render(scene, settings);
        };
        costs.push_back({"glsl", {}, millisecondsOf([&] {
                             draw();
                             gl->finish();
                         })});
        if (!drawn)
            return drawn.error();
        works.emplace_back([gl, draw] { return gl->millisecondsOf(draw); });
    }
    const auto timings = interleaved(works, effort.repetitions, 1.0, progress, 1.0);
    for (std::size_t i = 0; i < timings.size(); ++i)
        costs[i].shading = timings[i];
    if (!drawn)
        return drawn.error();
    return costs;
}

} // namespace reflectance
