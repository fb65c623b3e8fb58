#include "app/explorer/lab_runs.h"

#include <utility>

namespace reflectance::explorer {

namespace {

void start(Session& session)
{
    LabStudy& study = session.state.lab;
    std::shared_ptr<const LabRun> from = study.canGoOn() ? study.run : nullptr;
    if (!from)
        session.labLive->show(nullptr);
    study.measured = study.wish;
    study.problem.clear();
    session.lab.start([wish = study.wish, from = std::move(from), live = session.labLive](Progress& progress) {
        return measuredAsWished(wish, from, *live, Window::wake, progress);
    });
}

} // namespace

void pollLab(Session& session)
{
    LabStudy& study = session.state.lab;
    if (std::exchange(study.stopped, false))
        session.lab.cancel();
    if (std::exchange(study.asked, false))
        start(session);
    if (std::optional<LabOutcome> outcome = session.lab.take())
        study.problem = std::move(outcome->problem);
    study.run = session.labLive->latest();
    study.running = session.lab.busy();
    study.done = session.lab.done();
}

} // namespace reflectance::explorer
