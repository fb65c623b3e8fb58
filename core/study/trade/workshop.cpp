#include "core/study/trade/workshop.h"

#include "core/base/check.h"
#include "core/image/upscale.h"
#include "core/scene/requirements.h"
#include "core/study/cost/timing.h"

#include <algorithm>

namespace reflectance {
namespace {

/// Textures that GL keeps for a view: triangle, depth, N and, where needed, P per sample; the linear and the developed picture.
std::size_t glBytes(const RenderSettings& settings, bool halfBuffer, bool positions)
{
    const std::size_t pixels = Image::pixelCount(settings.width, settings.height);
    return settings.samples() * (4 + 4 + 16 + (positions ? 16 : 0)) + pixels * ((halfBuffer ? 8 : 16) + 4);
}

std::size_t pictureBytes(const RenderSettings& settings)
{
    return Image::pixelCount(settings.width, settings.height) * 4 * sizeof(float);
}

Scene bodyOf(Scene scene)
{
    scene.surface.model = "lambert_color";
    return scene;
}

Scene highlightOf(Scene scene)
{
    scene.surface.model = "phong";
    scene.background = {BackgroundKind::Plain, {}};
    return scene;
}

void add(const Image& more, Image& image)
{
    std::transform(image.rgb.begin(), image.rgb.end(), more.rgb.begin(), image.rgb.begin(), std::plus<>());
}

} // namespace

Workshop::Workshop(std::shared_ptr<const Mesh> mesh, const Camera& camera, GlRenderer* gl)
    : mesh_(std::move(mesh)), camera_(camera), gl_(gl)
{
}

GlShading glShadingOf(const Recipe& recipe)
{
    return {recipe.place, recipe.halfBuffer, recipe.lobe, recipe.specialised};
}

void Workshop::look(std::shared_ptr<const ViewSamples> samples)
{
    const RenderSettings& settings = samples->settings;
    const ViewKey key{settings.width, settings.height, settings.samplesPerAxis};
    views_[key] = {std::move(samples), 0.0};
}

const Workshop::Seen& Workshop::seen(const RenderSettings& settings)
{
    Seen& view = views_[{settings.width, settings.height, settings.samplesPerAxis}];
    if (view.samples)
        return view;
    if (!rays_)
        meshMilliseconds_ = millisecondsOf([&] { rays_ = makeRayScene(mesh_); });
    view.milliseconds = millisecondsOf(
        [&] { view.samples = std::make_shared<const ViewSamples>(sampleView(*rays_, camera_, settings)); });
    return view;
}

Result<Prepared> Workshop::prepare(const Recipe& recipe)
{
    Prepared prepared;
    prepared.recipe = recipe;
    const RenderSettings drawn = drawnSettings(recipe);
    if (recipe.onGl()) {
        CHECK_EQ(hasGl(), true);
        if (auto done = drawOnGl(prepared); !done) // compiles what is new, so that the look is timed without
            return done.error();
        prepared.lookMilliseconds = gl_->millisecondsOf([&] {
            gl_->invalidateSamples();
            // It has just been drawn.
            static_cast<void>(drawOnGl(prepared));
        });
        prepared.bytes = glBytes(drawn, recipe.halfBuffer, requirementsOf(recipe.scene, recipe.arithmetic()).positions);
        return prepared;
    }
    const Seen& view = seen(drawn);
    prepared.lookMilliseconds = view.milliseconds;
    const Place place = recipe.lobePerSample ? Place::Sample : recipe.place;
    prepared.lookMilliseconds += millisecondsOf([&] { prepared.view = placedView(view.samples, *mesh_, place); });
    prepared.shadings = prepared.view.shadings();
    prepared.bytes = prepared.view.bytes() + pictureBytes(drawn);
    if (recipe.lobePerSample) {
        prepared.bodyView = std::make_shared<const PlacedView>(placedView(view.samples, *mesh_, recipe.place));
        prepared.shadings += prepared.bodyView->shadings();
        prepared.bytes += prepared.bodyView->bytes() + pictureBytes(drawn);
    }
    return prepared;
}

Image Workshop::shadedOnCpu(const Prepared& prepared) const
{
    const Recipe& recipe = prepared.recipe;
    Image image;
    if (prepared.bodyView) {
        image = shadePlaces(*prepared.bodyView, bodyOf(recipe.scene), recipe.arithmetic());
        add(shadePlaces(prepared.view, highlightOf(recipe.scene), recipe.arithmetic()), image);
    } else {
        image = shadePlaces(prepared.view, recipe.scene, recipe.arithmetic());
    }
    return recipe.reduction == 1 ? image : upscaled(image, recipe.settings.width, recipe.settings.height);
}

Result<void> Workshop::drawOnGl(const Prepared& prepared)
{
    const Recipe& recipe = prepared.recipe;
    return gl_->render(recipe.scene, drawnSettings(recipe), glShadingOf(recipe));
}

Result<Image> Workshop::picture(const Prepared& prepared)
{
    if (!prepared.recipe.onGl())
        return shadedOnCpu(prepared);
    if (auto drawn = drawOnGl(prepared); !drawn)
        return drawn.error();
    Image image = gl_->readLinear();
    if (prepared.recipe.reduction == 1)
        return image;
    return upscaled(image, prepared.recipe.settings.width, prepared.recipe.settings.height);
}

Result<double> Workshop::shadingTime(const Prepared& prepared)
{
    if (!prepared.recipe.onGl())
        return millisecondsOf([&] { static_cast<void>(shadedOnCpu(prepared)); });
    if (auto drawn = drawOnGl(prepared); !drawn) // another recipe may have been in its place
        return drawn.error();
    return gl_->millisecondsOf([&] {
        gl_->invalidateShading();
        static_cast<void>(drawOnGl(prepared));
    });
}

Image Workshop::truth(const Scene& scene, const RenderSettings& settings, Progress* progress, double share)
{
    return renderOnCpu(scene, {settings.width, settings.height, 8}, Precision::Double, progress, share);
}

} // namespace reflectance
