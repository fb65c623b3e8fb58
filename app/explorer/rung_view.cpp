#include "app/explorer/rung_view.h"

#include "app/explorer/user_folders.h"
#include "core/image/upscale.h"
#include "core/scene/same_scene.h"

namespace reflectance::explorer {
namespace {

Recipe baseOf(const Scene& variant, const RenderSettings& settings)
{
    return {variant, settings, Precision::Glsl};
}

/// What the CPU sees stays while nothing of this changes.
bool sameView(const Scene& a, const Scene& b)
{
    return a.mesh == b.mesh && a.camera == b.camera;
}

RungPicture made(const Scene& variant, const RenderSettings& settings, Workshop& workshop)
{
    RungPicture picture;
    auto with = withItsRungs(baseOf(variant, settings));
    if (!with) {
        picture.problem = with.error().sentence();
        return picture;
    }
    picture.recipe = std::move(with->recipe);
    picture.withoutEffect = std::move(with->withoutEffect);
    if (picture.recipe.onGl())
        return picture;
    const auto prepared = workshop.prepare(picture.recipe);
    auto image = prepared ? workshop.picture(*prepared) : Result<Image>(prepared.error());
    if (!image) {
        picture.problem = image.error().sentence();
        return picture;
    }
    picture.codes = develop(*image, variant.sensor);
    picture.image = *std::move(image);
    return picture;
}

} // namespace

void RungView::drop()
{
    asked_.reset();
    shown_.reset();
    wanted_.reset();
    picture_.reset();
    workshop_.reset();
    withoutEffect_.clear();
    work_.cancel();
}

void RungView::start(const Wanted& wanted, std::shared_ptr<const ViewSamples> seen)
{
    const bool stays = workshop_ && asked_ && sameView(asked_->variant, wanted.variant) &&
                       asked_->settings == wanted.settings && asked_->seenByGl == wanted.seenByGl;
    if (!stays) {
        workshop_ = std::make_shared<Workshop>(wanted.variant.mesh, wanted.variant.camera, nullptr);
        if (seen)
            workshop_->look(std::move(seen));
    }
    asked_ = wanted;
    work_.start([wanted, workshop = workshop_](Progress&) {
        return std::optional(made(wanted.variant, wanted.settings, *workshop));
    });
}

Result<void> RungView::show(RungPicture picture)
{
    shown_ = asked_;
    withoutEffect_ = picture.withoutEffect;
    picture_ = std::move(picture);
    if (!picture_->problem.empty())
        return Error{picture_->problem};
    ++pictures_;
    if (picture_->codes) {
        texture_.show(picture_->codes->width, picture_->codes->height, picture_->codes->rgb);
        return {};
    }
    if (!renderer_) {
        Result<GlRenderer> renderer = GlRenderer::create(load_, programsFolder());
        if (!renderer)
            return renderer.error();
        renderer_.emplace(*std::move(renderer));
    }
    const Recipe& recipe = picture_->recipe;
    return renderer_->render(recipe.scene, drawnSettings(recipe), glShadingOf(recipe));
}

Result<void> RungView::update(const Scene& variant, const RenderSettings& settings, const SeenByGl& seen)
{
    const auto same = [](const std::optional<Wanted>& a, const Wanted& b) {
        return a && a->variant == b.variant && a->settings == b.settings && a->seenByGl == b.seenByGl;
    };
    const bool byCpu = !drawnByGl(variant.surface.rungs, true);
    wanted_ = Wanted{variant, settings, byCpu && seen};
    Result<void> shown;
    if (std::optional<RungPicture> picture = work_.take())
        shown = show(*std::move(picture));
    if (!work_.busy() && !same(asked_, *wanted_))
        start(*wanted_, wanted_->seenByGl ? seen() : nullptr);
    return shown;
}

unsigned RungView::texture() const
{
    if (!picture_ || !picture_->problem.empty())
        return 0;
    return picture_->codes ? texture_.id() : renderer_ ? renderer_->developedTexture() : 0;
}

bool RungView::rowsFromTop() const
{
    return picture_ && picture_->codes.has_value();
}

bool RungView::current() const
{
    return shown_ && wanted_ && texture() != 0 && shown_->variant == wanted_->variant &&
           shown_->settings == wanted_->settings && shown_->seenByGl == wanted_->seenByGl;
}

Image RungView::linear()
{
    const Recipe& recipe = picture_->recipe;
    if (picture_->image)
        return *picture_->image;
    Image image = renderer_->readLinear();
    return recipe.reduction == 1 ? image : upscaled(image, recipe.settings.width, recipe.settings.height);
}

Result<Image> pictureByRungs(const Scene& variant, const RenderSettings& settings, GlRenderer& gl,
                             const std::shared_ptr<const ViewSamples>& seen)
{
    const auto with = withItsRungs(baseOf(variant, settings));
    if (!with)
        return with.error();
    Workshop workshop(variant.mesh, variant.camera, &gl);
    if (seen)
        workshop.look(seen);
    const auto prepared = workshop.prepare(with->recipe);
    return prepared ? workshop.picture(*prepared) : Result<Image>(prepared.error());
}

} // namespace reflectance::explorer
