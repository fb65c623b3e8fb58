#include "app/cli/lens_picture.h"

#include "app/cli/long_work.h"
#include "core/image/picture_file.h"
#include "core/render/gl/gl_renderer.h"
#include "core/study/lens/palette.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

/// A picture and the samples it was made from.
struct Shaded {
    ViewSamples samples;
    Image image;
};

Result<Shaded> shadedByGl(const Scene& scene, const RenderSettings& settings, ContextKind kind)
{
    auto context = openHeadless(kind);
    if (!context)
        return context.error();
    auto renderer = GlRenderer::create((*context)->loader());
    if (!renderer)
        return renderer.error();
    if (const auto drawn = renderer->render(scene, settings); !drawn)
        return drawn.error();
    return Shaded{renderer->readSamples(), renderer->readLinear()};
}

Result<Shaded> shadedByCpu(const Scene& scene, const RenderSettings& settings, LensKind kind)
{
    Shaded shaded;
    shaded.samples = sampleView(*makeRayScene(scene.mesh, settings), scene.camera, settings, &LongWork::progress());
    shaded.image = shadedFor(kind, shaded.samples, scene, &LongWork::progress());
    return shaded;
}

} // namespace

LensKind lensNamed(std::string_view name)
{
    const auto* found = std::ranges::find_if(lensKinds, [name](LensKind kind) { return nameOf(kind) == name; });
    return found == std::end(lensKinds) ? LensKind::Float : *found;
}

Result<LensMap> lensOf(const Scene& scene, const RenderSettings& settings, LensKind kind, ContextKind context)
{
    const LongWork work;
    const auto shaded =
        kind == LensKind::Glsl ? shadedByGl(scene, settings, context) : shadedByCpu(scene, settings, kind);
    if (!shaded)
        return shaded.error();
    auto map = lensMap(kind, shaded->samples, shaded->image, scene, LongWork::progress());
    if (!map)
        return Error{"stopped; nothing was written"};
    return *std::move(map);
}

Result<void> writeLens(const std::string& path, const LensMap& map, const Notes& notes)
{
    return writePng(path, map.width, map.height, painted(map), {}, notes);
}

nlohmann::ordered_json lensReport(LensKind kind, const LensMap& map)
{
    const LensFigures figures = figuresOf(map);
    return {{"lens", nameOf(kind)},
            {"most_digits", mostDigits(kind)},
            {"covered_pixels", figures.covered},
            {"fewest_digits", figures.fewest},
            {"median_digits", figures.median},
            {"nan_pixels", figures.notANumber},
            {"infinite_pixels", figures.infinite},
            {"negative_pixels", figures.negative},
            {"above_passive_pixels", figures.abovePassive}};
}

} // namespace reflectance::cli
