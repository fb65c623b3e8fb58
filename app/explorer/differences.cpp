#include "app/explorer/differences.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance::explorer {
namespace {

constexpr std::chrono::milliseconds restBeforePerceiving{250};

double restOwed(const Session& session)
{
    return std::chrono::duration<double>(restBeforePerceiving - (Clock::now() - session.lastChange)).count();
}

bool current(const Session& session)
{
    return session.second.measured == session.viewport.pictures &&
           session.second.measuredRegion == session.state.compare.region;
}

void takeOver(Session& session)
{
    const std::optional<DifferencePicture> done = session.second.work.take();
    CompareView& compare = session.state.compare;
    if (!done || !compare.on)
        return;
    session.second.map.show(done->width, done->height, done->rgb);
    compare.figures = done->figures;
    compare.scale = done->scale;
}

} // namespace

double secondsUntilDifference(const Session& session)
{
    const bool done = current(session) && session.second.measuredPerceived;
    const bool drawn = session.second.current(session.state.scene); // else a thread wakes the loop when it is
    if (!session.state.compare.on || session.second.work.busy() || done || !drawn)
        return std::numeric_limits<double>::infinity();
    return current(session) ? std::max(0.0, restOwed(session)) : 0.0;
}

void pollDifference(Session& session)
{
    SecondView& second = session.second;
    takeOver(session);
    if (!session.state.compare.on) {
        session.state.compare.figures.reset();
        second.measured = 0;
        return;
    }
    const Scene& scene = session.state.scene;
    if (secondsUntilDifference(session) > 0.0 || !second.current(scene))
        return;
    const bool perceived = restOwed(session) <= 0.0;
    second.measured = session.viewport.pictures;
    second.measuredPerceived = perceived;
    second.measuredRegion = session.state.compare.region;
    second.work.start([a = second.linearA(scene, session.renderer), b = second.linearB(scene),
                       exposure = std::log2(gainOf(scene.sensor)), perceived, region = session.state.compare.region](
                          Progress& progress) { return differenceOf(a, b, exposure, perceived, progress, region); });
}

} // namespace reflectance::explorer
