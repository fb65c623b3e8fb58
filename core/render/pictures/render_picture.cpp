#include "core/render/pictures/render_picture.h"

#include "core/math/quantile.h"
#include "core/reflectance/kernel_tables.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/render/gl/gl_renderer.h"
#include "core/scene/requirements.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace reflectance {
namespace {

constexpr std::uint64_t bytesOfPositions = 16; ///< a texel of four floats per sample

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The medians of the shadings after the first: shade(specialised) gives milliseconds. The general path, where it is asked
/// for, takes turns with the other, which comes last and leaves the picture.
template <class Shade> void timeShadings(const RenderPlan& plan, Shade shade, Rendered& rendered)
{
    std::vector<double> asPlanned;
    std::vector<double> general;
    if (plan.alsoGeneral && plan.frames > 1)
        static_cast<void>(shade(false)); // links a program, warms caches
    for (int i = 1; i < plan.frames; ++i) {
        if (plan.alsoGeneral)
            general.push_back(shade(false));
        asPlanned.push_back(shade(plan.specialised));
    }
    rendered.shadingMilliseconds = medianOf(std::move(asPlanned));
    rendered.generalMilliseconds = medianOf(std::move(general));
}

/// Shades `plan.frames` times what was sampled once.
void renderFrames(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan, Progress* progress,
                  Rendered& rendered)
{
    const Clock::time_point start = Clock::now();
    const PlacedView view = placedView(std::make_shared<const ViewSamples>(sampleView(
                                           *makeRayScene(scene.mesh, settings), scene.camera, settings, progress)),
                                       *scene.mesh, plan.place);
    const auto shade = [&](bool specialised) {
        const Clock::time_point shadingStart = Clock::now();
        rendered.image = shadePlaces(view, scene, {plan.precision, plan.lobe, specialised});
        return millisecondsSince(shadingStart);
    };
    static_cast<void>(shade(plan.specialised));
    rendered.firstFrameMilliseconds = millisecondsSince(start);
    timeShadings(plan, shade, rendered);
}

Result<Rendered> renderByCpu(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                             Progress* progress)
{
    Rendered rendered;
    rendered.backend = "cpu";
    rendered.precision = nameWithLanes(plan.precision);
    if (plan.frames == 1 && plan.place == Place::Sample) { // keeps no samples: huge pictures stay small
        const Clock::time_point start = Clock::now();
        rendered.image = renderOnCpu(scene, settings, {plan.precision, plan.lobe, plan.specialised}, progress);
        rendered.firstFrameMilliseconds = millisecondsSince(start);
    } else {
        renderFrames(scene, settings, plan, progress, rendered);
    }
    if (progress != nullptr && progress->cancel)
        return Error{"stopped; nothing was written"};
    return rendered;
}

Result<Rendered> renderByGl(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                            HeadlessContext& context)
{
    Rendered rendered;
    rendered.backend = "gl (" + std::string(context.name()) + ")";
    rendered.precision = nameOf(Precision::Glsl);
    const Clock::time_point start = Clock::now();
    auto renderer = GlRenderer::create(context.loader(), plan.programs);
    if (!renderer)
        return renderer.error();
    GlShading how{plan.place, false, plan.lobe, plan.specialised};
    if (const auto drawn = renderer->renderLinear(scene, settings, how); !drawn)
        return drawn.error();
    renderer->finish();
    rendered.firstFrameMilliseconds = millisecondsSince(start);
    Result<void> last;
    const auto shade = [&](bool specialised) {
        how.specialised = specialised;
        return renderer->millisecondsOf([&] {
            renderer->invalidateShading();
            last = renderer->renderLinear(scene, settings, how);
        });
    };
    timeShadings(plan, shade, rendered);
    if (!last)
        return last.error();
    rendered.image = renderer->readLinear();
    if (plan.specialised && !requirementsOf(scene, {Precision::Glsl, plan.lobe}).positions)
        rendered.leftOutBytes = bytesOfPositions * settings.samples();
    return rendered;
}

} // namespace

Result<Rendered> renderPicture(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                               Progress* progress)
{
    const bool onMesh = plan.place == Place::Vertex || plan.place == Place::Face;
    if (onMesh && plan.backend == Backend::Gl)
        return Error{"shading per " + std::string(nameOf(plan.place)) +
                     " belongs to the CPU renderer; leave the GL backend out, or shade per pixel"};
    if (plan.backend == Backend::Cpu || onMesh)
        return renderByCpu(scene, settings, plan, progress);
    auto context = openHeadless(plan.context);
    if (context)
        return renderByGl(scene, settings, plan, **context);
    if (plan.backend == Backend::Gl)
        return context.error();
    return renderByCpu(scene, settings, plan, progress);
}

std::string nameWithLanes(Precision precision)
{
    std::string name(nameOf(precision));
    if (precision == Precision::Simd)
        name += std::string(" (") + lanesName() + ")";
    return name;
}

ContextKind contextNamed(std::string_view name)
{
    return name == "osmesa" ? ContextKind::OsMesa : name == "egl" ? ContextKind::Egl : ContextKind::Any;
}

} // namespace reflectance
