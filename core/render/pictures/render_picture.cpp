#include "core/render/pictures/render_picture.h"

#include "core/reflectance/kernel_tables.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/render/gl/gl_renderer.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace reflectance {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The median of the shadings after the first.
template <class Shade> double medianMilliseconds(int repetitions, Shade shade)
{
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
        const Clock::time_point start = Clock::now();
        shade();
        times.push_back(millisecondsSince(start));
    }
    if (times.empty())
        return 0.0;
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
    return times[times.size() / 2];
}

/// Shades `plan.frames` times what was sampled once.
void renderFrames(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan, Progress* progress,
                  Rendered& rendered)
{
    const Arithmetic arithmetic(plan.precision, plan.lobe, plan.specialised);
    const Clock::time_point start = Clock::now();
    const PlacedView view = placedView(
        std::make_shared<const ViewSamples>(sampleView(*makeRayScene(scene.mesh), scene.camera, settings, progress)),
        *scene.mesh, plan.place);
    const auto shade = [&] { rendered.image = shadePlaces(view, scene, arithmetic); };
    shade();
    rendered.firstFrameMilliseconds = millisecondsSince(start);
    rendered.shadingMilliseconds = medianMilliseconds(plan.frames - 1, shade);
}

Result<Rendered> renderByCpu(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                             Progress* progress)
{
    Rendered rendered;
    rendered.backend = "cpu";
    rendered.precision = std::string(nameOf(plan.precision));
    if (plan.precision == Precision::Simd)
        rendered.precision += std::string(" (") + lanesName() + ")";
    if (plan.frames == 1 && plan.place == Place::Sample) { // in bands, which keeps huge pictures small in memory
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
    auto renderer = GlRenderer::create(context.loader());
    if (!renderer)
        return renderer.error();
    const GlShading how{plan.place, false, plan.lobe, plan.specialised};
    if (const auto drawn = renderer->render(scene, settings, how); !drawn)
        return drawn.error();
    renderer->finish();
    rendered.firstFrameMilliseconds = millisecondsSince(start);
    Result<void> last;
    rendered.shadingMilliseconds = medianMilliseconds(plan.frames - 1, [&] {
        renderer->invalidateShading();
        last = renderer->render(scene, settings, how);
        renderer->finish();
    });
    if (!last)
        return last.error();
    rendered.image = renderer->readLinear();
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

ContextKind contextNamed(std::string_view name)
{
    return name == "osmesa" ? ContextKind::OsMesa : name == "egl" ? ContextKind::Egl : ContextKind::Any;
}

} // namespace reflectance
