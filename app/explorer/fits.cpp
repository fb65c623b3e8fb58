#include "app/explorer/fits.h"

#include <utility>

namespace reflectance::explorer {

void pollFit(Session& session)
{
    FitStudy& study = session.state.fit;
    if (std::exchange(study.stopped, false))
        session.fit.cancel();
    if (std::exchange(study.asked, false))
        session.fit.start([wish = study.wish](Progress& progress) { return fittedAsWished(wish, progress); });
    if (std::optional<FitOutcome> outcome = session.fit.take())
        study.outcome = std::make_shared<const FitOutcome>(*std::move(outcome));
    study.running = session.fit.busy();
    study.done = session.fit.done();
}

} // namespace reflectance::explorer
