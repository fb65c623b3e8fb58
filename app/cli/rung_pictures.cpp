#include "app/cli/rung_pictures.h"

#include "app/explorer/shown_picture.h"
#include "core/math/quantile.h"
#include "core/study/cost/timing.h"
#include "core/study/trade/workshop.h"

#include <utility>

namespace reflectance::cli {

bool asksForRungs(const Scene& scene, VariantView shown)
{
    const bool a = shown != VariantView::B && !scene.surface.rungs.empty();
    const bool b = shown != VariantView::A && scene.other && !scene.other->rungs.empty();
    return a || b;
}

RungPictures::RungPictures(const Scene& scene, VariantView shown, const RenderPlan& plan)
    : scene_(scene), both_(explorer::showsBoth(shown)), plan_(plan)
{
    const bool onMesh = plan.place == Place::Vertex || plan.place == Place::Face;
    onGl_ = plan.backend != Backend::Cpu && !onMesh && openGl().has_value();
}

Result<void> RungPictures::openGl()
{
    if (renderer_)
        return {};
    auto context = openHeadless(plan_.context);
    if (!context)
        return context.error();
    auto renderer = GlRenderer::create((*context)->loader(), plan_.programs);
    if (!renderer)
        return renderer.error();
    context_ = *std::move(context);
    renderer_.emplace(*std::move(renderer));
    return {};
}

bool RungPictures::besideGl(const Scene& variant) const
{
    if (!both_ || !scene_.other)
        return false;
    const bool isA = variant.surface == scene_.surface;
    return drawnByGl((isA ? *scene_.other : scene_.surface).rungs, onGl_);
}

Result<Rendered> RungPictures::drawn(const Recipe& recipe, std::shared_ptr<const ViewSamples> seen)
{
    Workshop workshop(recipe.scene.mesh, recipe.scene.camera, renderer_ ? &*renderer_ : nullptr);
    if (seen)
        workshop.look(std::move(seen));
    const auto prepared = workshop.prepare(recipe);
    if (!prepared)
        return prepared.error();
    auto image = Result<Image>(Error{});
    const double first = millisecondsOf([&] { image = workshop.picture(*prepared); });
    if (!image)
        return image.error();
    std::vector<double> times;
    for (int frame = 1; frame < plan_.frames; ++frame) {
        const auto milliseconds = workshop.shadingTime(*prepared);
        if (!milliseconds)
            return milliseconds.error();
        times.push_back(*milliseconds);
    }
    Rendered rendered;
    rendered.image = *std::move(image);
    rendered.backend = recipe.onGl() ? "gl (" + std::string(context_->name()) + ")" : "cpu";
    rendered.precision = nameWithLanes(recipe.precision);
    rendered.firstFrameMilliseconds = workshop.meshMilliseconds() + prepared->lookMilliseconds + first;
    rendered.shadingMilliseconds = medianOf(std::move(times));
    return rendered;
}

Result<Rendered> RungPictures::render(const Scene& variant, const RenderSettings& settings)
{
    Recipe base{variant, settings, onGl_ ? Precision::Glsl : plan_.precision, plan_.lobe, plan_.place};
    base.specialised = plan_.specialised;
    const auto with = withItsRungs(base);
    if (!with)
        return with.error();
    withoutEffect_.insert(withoutEffect_.end(), with->withoutEffect.begin(), with->withoutEffect.end());
    std::shared_ptr<const ViewSamples> seen;
    if (const bool shares = !with->recipe.onGl() && besideGl(variant); shares || with->recipe.onGl()) {
        if (auto opened = openGl(); !opened)
            return opened.error();
        if (shares) {
            if (auto looked = renderer_->render(variant, settings); !looked)
                return looked.error();
            seen = std::make_shared<const ViewSamples>(renderer_->readSamples());
        }
    }
    return drawn(with->recipe, std::move(seen));
}

std::string RungPictures::backend() const
{
    return onGl_ ? "gl (" + std::string(context_->name()) + ")" : "cpu";
}

std::string RungPictures::precision() const
{
    return nameWithLanes(onGl_ ? Precision::Glsl : plan_.precision);
}

} // namespace reflectance::cli
