#include "app/explorer/second_view.h"

#include "app/explorer/user_folders.h"

namespace reflectance::explorer {

namespace {

bool hasRungs(const Scene& scene)
{
    return !scene.surface.rungs.empty();
}

bool hasRungsB(const Scene& scene)
{
    return scene.other && !scene.other->rungs.empty();
}

} // namespace

Result<void> SecondView::renderB(const Scene& b, const RenderSettings& settings)
{
    if (!renderer) {
        Result<GlRenderer> made = GlRenderer::create(load, programsFolder());
        if (!made)
            return made.error();
        renderer.emplace(*std::move(made));
    }
    return renderer->render(b, settings);
}

Result<void> SecondView::render(const Scene& scene, bool comparing, const RenderSettings& settings, GlRenderer& first)
{
    const bool byRungsA = hasRungs(scene);
    const bool byRungsB = comparing && hasRungsB(scene);
    // Beside a picture of GL's the CPU shades what GL saw: what separates the two is then arithmetic alone.
    const SeenByGl looked = [&first] { return std::make_shared<const ViewSamples>(first.readSamples()); };
    const auto beside = [&](const Surface& other) {
        return comparing && drawnByGl(other.rungs, true) ? looked : SeenByGl();
    };
    Result<void> drawn;
    if (byRungsA)
        drawn = rungsA.update(scene, settings, beside(scene.other ? *scene.other : scene.surface));
    else
        rungsA.drop();
    if (!byRungsB)
        rungsB.drop();
    if (!drawn || !comparing)
        return drawn;
    const Scene b = variantB(scene);
    return byRungsB ? rungsB.update(b, settings, beside(scene.surface)) : renderB(b, settings);
}

std::uint64_t SecondView::pictures() const
{
    return (renderer ? renderer->work().shadings + renderer->work().developments : 0) + rungsA.pictures() +
           rungsB.pictures();
}

ShownTexture SecondView::shownA(const Scene& scene, const GlRenderer& first) const
{
    if (hasRungs(scene) && rungsA.texture() != 0)
        return {rungsA.texture(), rungsA.rowsFromTop()};
    return {first.developedTexture(), false};
}

ShownTexture SecondView::shownB(const Scene& scene, const GlRenderer& first) const
{
    if (hasRungsB(scene) && rungsB.texture() != 0)
        return {rungsB.texture(), rungsB.rowsFromTop()};
    return {renderer ? renderer->developedTexture() : first.developedTexture(), false};
}

Image SecondView::linearA(const Scene& scene, GlRenderer& first)
{
    return hasRungs(scene) ? rungsA.linear() : first.readLinear();
}

Image SecondView::linearB(const Scene& scene)
{
    return hasRungsB(scene) ? rungsB.linear() : renderer->readLinear();
}

bool SecondView::current(const Scene& scene) const
{
    return (!hasRungs(scene) || rungsA.current()) && (hasRungsB(scene) ? rungsB.current() : renderer.has_value());
}

} // namespace reflectance::explorer
