#include "app/explorer/own_models.h"

#include "core/reflectance/own_model.h"

#include <utility>

namespace reflectance::explorer {

Result<void> compiled(GlRenderer& renderer, const Model& model)
{
    const Observation row{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {{{0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}, 0.0}}};
    const auto values = renderer.evaluate(model, flatValues(model.text, {}), std::span(&row, 1), nullptr);
    if (!values)
        return values.error();
    return {};
}

void useModel(Surface& surface, std::shared_ptr<const Model> model, const std::string& path)
{
    surface.model = model->id();
    surface.own = std::move(model);
    surface.modelFile = path;
}

bool renewIn(Scene& scene, const std::shared_ptr<const Model>& model, const std::string& path)
{
    bool found = false;
    std::vector<Surface*> surfaces{&scene.surface};
    if (scene.other)
        surfaces.push_back(&*scene.other);
    for (KeptSurface& variant : scene.variants)
        surfaces.push_back(&variant.surface);
    for (Surface* surface : surfaces)
        if (surface->own && surface->modelFile == path) {
            surface->own = model;
            found = true;
        }
    return found;
}

void OwnModelWatch::watch(const std::string& path)
{
    std::error_code unknown;
    path_ = path;
    seen_ = std::filesystem::last_write_time(path, unknown);
}

std::optional<Result<std::shared_ptr<const Model>>> OwnModelWatch::saved(Time now)
{
    if (path_.empty() || now - looked_ < pause)
        return std::nullopt;
    looked_ = now;
    std::error_code gone; // an editor may replace the file: between the two there is none
    const auto changed = std::filesystem::last_write_time(path_, gone);
    if (gone || changed == seen_)
        return std::nullopt;
    seen_ = changed;
    return readOwnModel(path_);
}

} // namespace reflectance::explorer
