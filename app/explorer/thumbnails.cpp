#include "app/explorer/thumbnails.h"

#include <algorithm>

namespace reflectance::explorer {
namespace {

/// So many that a batch is there within a blink, and lights that move are soon followed.
constexpr std::size_t batch = 6;

void takeOver(Session& session)
{
    const auto made = session.thumbnails.take();
    if (!made)
        return;
    for (const Thumbnail& thumbnail : *made) {
        const auto [texture, isNew] = session.thumbnailTextures.try_emplace(thumbnail.id, Window::loader());
        texture->second.show(thumbnailSize, thumbnailSize, thumbnail.rgb);
        session.state.shelf.pictures[thumbnail.id] = {texture->second.id(), thumbnail.budget, false};
    }
}

bool sameLight(const Scene& a, const Scene& b)
{
    return a.lights == b.lights && a.environment == b.environment && a.sensor == b.sensor;
}

} // namespace

void pollThumbnails(Session& session)
{
    SurfaceShelf& shelf = session.state.shelf;
    const std::vector<std::string> wanted = std::exchange(shelf.wanted, {});
    if (session.thumbnails.busy()) {
        takeOver(session);
        return;
    }
    Scene lit = shownScene(session.state);
    if (!sameLight(lit, session.thumbnailLight)) {
        for (auto& [id, picture] : shelf.pictures)
            picture.stale = true;
        session.thumbnailLight = lit;
    }
    if (wanted.empty() || session.viewport.dragging())
        return;
    const std::vector<std::string> next(wanted.begin(),
                                        wanted.begin() + static_cast<std::ptrdiff_t>(std::min(batch, wanted.size())));
    session.thumbnails.start(
        [lit = std::move(lit), next](Progress& progress) { return makeThumbnails(lit, next, progress); });
}

} // namespace reflectance::explorer
