#include "app/explorer/trust.h"

#include "app/explorer/session.h"
#include "core/study/lens/palette.h"
#include "core/study/lens/thinned.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {
namespace {

/// Pixels that the check looks at, and that the lens paints first: a tenth of a second of work.
constexpr std::size_t checkedPixels = 2500;
constexpr double firstPainted = 20000.0;

int firstStride(const Image& picture)
{
    return std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(picture.pixels()) / firstPainted))));
}

std::optional<LensLaid> laid(const Rested& rested, LensKind kind, int stride, Progress& progress)
{
    const bool whole = stride == 1;
    const ViewSamples few = whole ? ViewSamples() : everyNth(rested.drawn.samples, stride);
    const ViewSamples& samples = whole ? rested.drawn.samples : few;
    LensLaid lens{kind, stride, {}, {}};
    lens.image = kind == LensKind::Glsl ? everyNth(rested.drawn.linear, stride)
                                        : shadedFor(kind, samples, rested.scene, &progress);
    std::optional<LensMap> map = lensMap(kind, samples, lens.image, rested.scene, progress);
    if (!map)
        return std::nullopt;
    lens.map = *std::move(map);
    return lens;
}

void hideLens(Session& session)
{
    session.trust.laid.reset();
    session.trust.read.reset();
    session.viewport.overlay = 0;
    session.state.lensFigures.reset();
}

void takeLens(Session& session)
{
    Trust& trust = session.trust;
    std::optional<LensLaid> found = trust.lens.take();
    if (!found || session.state.lens != found->kind)
        return;
    trust.laid = std::move(found);
    trust.read.reset();
    trust.overlay.show(trust.laid->map.width, trust.laid->map.height, painted(trust.laid->map));
    session.viewport.overlay = trust.overlay.id();
    session.state.lensFigures = figuresOf(trust.laid->map);
}

/// The pixels' stride that is to be painted next; 0 where there is nothing to do.
int nextStride(const Session& session, LensKind kind)
{
    const Trust& trust = session.trust;
    if (!trust.rested || (trust.lens.busy() && trust.asked == kind))
        return 0;
    if (!trust.laid)
        return firstStride(trust.rested->drawn.linear);
    return trust.laid->stride > 1 ? 1 : 0;
}

void startLens(Session& session)
{
    Trust& trust = session.trust;
    if (!session.state.lens || (trust.laid && trust.laid->kind != *session.state.lens))
        hideLens(session);
    if (!session.state.lens) {
        trust.lens.cancel();
        return;
    }
    const LensKind kind = *session.state.lens;
    const int stride = nextStride(session, kind);
    if (stride == 0)
        return;
    trust.asked = kind;
    trust.lens.start(
        [rested = trust.rested, kind, stride](Progress& progress) { return laid(*rested, kind, stride, progress); });
}

} // namespace

void dropTrust(Session& session)
{
    session.trust.check.cancel();
    session.trust.lens.cancel();
    session.trust.rested.reset();
    session.state.glCheck.reset();
    hideLens(session);
}

void restTrust(Session& session, std::shared_ptr<const Rested> rested)
{
    session.trust.rested = rested;
    session.trust.check.start([rested = std::move(rested)](Progress& progress) {
        return checkGl(rested->drawn.samples, rested->drawn.linear, rested->scene, checkedPixels, progress);
    });
}

void pollTrust(Session& session)
{
    if (std::optional<GlCheck> check = session.trust.check.take())
        session.state.glCheck = *check;
    takeLens(session);
    startLens(session);
}

bool trustIsBusy(const Session& session)
{
    return session.trust.check.busy() || session.trust.lens.busy();
}

const LensReading* readPixel(Session& session, int x, int y)
{
    Trust& trust = session.trust;
    if (!trust.rested || !trust.laid || trust.laid->stride != 1 || x < 0 || y < 0 || x >= trust.laid->map.width ||
        y >= trust.laid->map.height)
        return nullptr;
    if (!trust.read || trust.read->x != x || trust.read->y != y)
        trust.read = {x, y,
                      readingAt(trust.laid->kind, trust.laid->map, trust.rested->drawn.samples, trust.laid->image,
                                trust.rested->scene, x, y)};
    return &trust.read->reading;
}

} // namespace reflectance::explorer
