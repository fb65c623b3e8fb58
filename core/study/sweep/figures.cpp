#include "core/study/sweep/figures.h"

#include "core/geometry/orbit_view.h"
#include "core/image/compare.h"
#include "core/image/perceived.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/render/cpu/shading_places.h"
#include "core/render/gl/gl_renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace reflectance {
namespace {

/// A picture, and double on the samples that it was made of.
struct Pair {
    Image image, truth;
    double milliseconds = 0.0;
};

template <class Work> double millisecondsOf(const Work& work)
{
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Precision precisionOf(CellRenderer renderer)
{
    return renderer == CellRenderer::Float  ? Precision::Float
           : renderer == CellRenderer::Simd ? Precision::Simd
                                            : Precision::Double;
}

Pair byCpu(const Scene& scene, const RayScene& rays, const Cell& cell, Progress* progress)
{
    const auto samples = std::make_shared<const ViewSamples>(sampleView(rays, scene.camera, cell.settings, progress));
    const PlacedView view =
        placedView(samples, *scene.mesh, cell.renderer == CellRenderer::Vertex ? Place::Vertex : Place::Sample);
    Pair pair;
    pair.milliseconds = millisecondsOf([&] { pair.image = shadePlaces(view, scene, precisionOf(cell.renderer)); });
    if (cell.renderer != CellRenderer::Double)
        pair.truth = shadeSamples(*samples, scene, Precision::Double, progress);
    return pair;
}

Result<Pair> byGl(const Scene& scene, const Cell& cell)
{
    const auto context = openHeadless(ContextKind::Any);
    if (!context)
        return context.error();
    auto renderer = GlRenderer::create((*context)->loader());
    if (!renderer)
        return renderer.error();
    if (const auto drawn = renderer->render(scene, cell.settings); !drawn)
        return drawn.error();
    Pair pair;
    Result<void> again;
    pair.milliseconds = renderer->millisecondsOf([&] {
        renderer->invalidateShading();
        again = renderer->render(scene, cell.settings);
    });
    if (!again)
        return again.error();
    pair.image = renderer->readLinear();
    pair.truth = shadeSamples(renderer->readSamples(), scene, Precision::Double);
    return pair;
}

/// Over the channels of the pixels that the object fills.
void lookAt(const Image& image, Figures& figures)
{
    double sum = 0.0, covered = 0.0;
    std::size_t filled = 0;
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const float* rgb = &image.rgb[3 * i];
        const auto isFinite = [](float v) { return std::isfinite(v); };
        figures.nonFinite += std::all_of(rgb, rgb + 3, isFinite) ? 0 : 1;
        figures.negative += std::any_of(rgb, rgb + 3, [](float v) { return v < 0.0F; }) ? 1 : 0;
        covered += double{image.coverage[i]};
        if (image.coverage[i] < 1.0F)
            continue;
        ++filled;
        for (int channel = 0; channel < 3; ++channel) {
            sum += double{rgb[channel]};
            figures.largest =
                filled == 1 && channel == 0 ? double{rgb[channel]} : std::max(figures.largest, double{rgb[channel]});
        }
    }
    figures.covered = covered / static_cast<double>(image.pixels());
    figures.mean = filled == 0 ? 0.0 : sum / (3.0 * static_cast<double>(filled));
}

Result<Figures> figuresOf(const Pair& pair)
{
    Figures figures;
    figures.milliseconds = pair.milliseconds;
    lookAt(pair.image, figures);
    if (pair.truth.rgb.empty() || figures.covered == 0.0) // the truth itself, or nothing but background
        return figures;
    const auto difference = compared(pair.truth, pair.image);
    if (!difference)
        return difference.error();
    figures.rmse = difference->rmse;
    figures.maxAbs = difference->maxAbs;
    const PerceivedDifference seen = PerceivedReference(pair.truth, Over::CoveredPixels).to(pair.image);
    figures.deltaEMean = seen.deltaEMean;
    figures.deltaEMax = seen.deltaEMax;
    figures.flip = seen.flipMean;
    return figures;
}

} // namespace

Result<ComputedCell> computeCell(const Cell& cell, const std::string& folder, KeptMeshes& meshes, Progress* progress)
{
    auto scene = meshes.scene(cell.scene, folder);
    if (!scene)
        return scene.error();
    if (const auto complete = checkSurface(scene->surface); !complete)
        return complete.error();
    if (cell.orbit)
        scene->camera = orbitView(scene->camera, (*cell.orbit)[0], (*cell.orbit)[1],
                                  static_cast<double>(cell.settings.width) / cell.settings.height);
    auto pair = cell.renderer == CellRenderer::Glsl ? byGl(*scene, cell)
                                                    : Result(byCpu(*scene, *meshes.rays(*scene), cell, progress));
    if (!pair)
        return pair.error();
    if (progress && progress->cancel)
        return Error{"stopped"};
    const auto figures = figuresOf(*pair);
    if (!figures)
        return figures.error();
    return ComputedCell{*figures, std::move(pair->image), scene->sensor};
}

} // namespace reflectance
