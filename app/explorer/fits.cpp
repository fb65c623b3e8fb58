#include "app/explorer/fits.h"

#include <utility>

namespace reflectance::explorer {

namespace {

void pollPhotograph(Session& session)
{
    FitStudy& study = session.state.fit;
    if (std::exchange(study.readPicture, false))
        session.photograph.start([file = study.pictureFile, sensor = session.state.scene.sensor](Progress& progress) {
            return photographFrom(file, sensor, progress);
        });
    std::optional<Photograph> photograph = session.photograph.take();
    if (!photograph)
        return;
    const Developed& shown = photograph->shown;
    if (photograph->problem.empty())
        session.photographTexture.show(shown.width, shown.height, shown.rgb);
    study.pictureTexture = session.photographTexture.id();
    study.wish.pixels.clear();
    study.wish.photograph = std::make_shared<const Photograph>(*std::move(photograph));
}

} // namespace

void pollFit(Session& session)
{
    FitStudy& study = session.state.fit;
    pollPhotograph(session);
    if (std::exchange(study.stopped, false))
        session.fit.cancel();
    if (std::exchange(study.asked, false)) {
        study.wish.scene = std::make_shared<const Scene>(shownScene(session.state));
        session.fit.start([wish = study.wish](Progress& progress) { return fittedAsWished(wish, progress); });
    }
    if (std::optional<FitOutcome> outcome = session.fit.take())
        study.outcome = std::make_shared<const FitOutcome>(*std::move(outcome));
    study.running = session.fit.busy() || session.photograph.busy();
    study.done = session.fit.done();
}

} // namespace reflectance::explorer
