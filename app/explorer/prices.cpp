#include "app/explorer/prices.h"

#include "app/explorer/viewed_scene.h"

#include <algorithm>
#include <limits>

namespace reflectance::explorer {
namespace {

bool owed(const Session& session)
{
    return session.pricedPicture != session.viewport.pictures && !session.viewport.refinementOwed &&
           !session.viewport.dragging() && !session.state.turntable;
}

/// GL's own samples, its picture of them, and what shading them once more takes.
std::shared_ptr<const Rested> drawnByGl(Session& session)
{
    GlRenderer& renderer = session.renderer;
    const Scene scene = viewedScene(session.state);
    Result<void> drawn;
    const double milliseconds = renderer.millisecondsOf([&] {
        renderer.invalidateShading();
        drawn = renderer.render(scene, session.viewport.settings);
    });
    if (!drawn)
        return nullptr;
    return std::make_shared<Rested>(Rested{scene, {renderer.readSamples(), renderer.readLinear(), milliseconds}});
}

void noteChange(Session& session)
{
    if (session.countedPicture == session.viewport.pictures)
        return;
    session.countedPicture = session.viewport.pictures;
    session.lastChange = Clock::now();
    session.prices.cancel();
    session.pricesWait = false;
    dropTrust(session);
    session.state.priceTags.clear();
    session.state.sensorCounts.reset();
    session.state.measuringPrices = true;
}

/// Once nothing else runs that would make them slow.
void startPrices(Session& session)
{
    if (!session.pricesWait || trustIsBusy(session))
        return;
    session.pricesWait = false;
    session.prices.start([rested = session.trust.rested](Progress& progress) {
        return measuredPrices(rested->scene, rested->drawn, progress);
    });
}

} // namespace

double secondsUntilPrices(const Session& session)
{
    if (!owed(session))
        return std::numeric_limits<double>::infinity();
    const auto rested = Clock::now() - session.lastChange;
    const Clock::duration rest = std::max<Clock::duration>(restBeforeMeasuring, restBeforeRefining(session.viewport));
    return std::chrono::duration<double>(rest - rested).count();
}

void pollPrices(Session& session)
{
    noteChange(session);
    if (std::optional<Prices> prices = session.prices.take()) {
        session.state.priceTags = std::move(prices->tags);
        session.state.sensorCounts = prices->counts;
        session.state.measuringPrices = false;
    }
    if (owed(session) && secondsUntilPrices(session) <= 0.0) {
        session.pricedPicture = session.viewport.pictures;
        if (std::shared_ptr<const Rested> rested = drawnByGl(session)) {
            restTrust(session, std::move(rested));
            // A term alone is walked on the CPU, which says nothing about what the surface costs.
            session.pricesWait = !seesTermAlone(session.state);
            session.state.measuringPrices = session.pricesWait;
        }
    }
    pollTrust(session);
    startPrices(session);
}

} // namespace reflectance::explorer
