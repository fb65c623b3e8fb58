#include "app/explorer/trades.h"

#include "app/explorer/session.h"
#include "app/explorer/study_renderer.h"
#include "core/image/compare.h"
#include "core/sensor/sensor.h"
#include "core/study/trade/dial.h"

#include <algorithm>
#include <utility>

namespace reflectance::explorer {
namespace {

/// So long a thread works before it hands over what it has; so long GL may hold up a frame.
constexpr std::chrono::milliseconds batch{250}, hold{30};
constexpr int termRepetitions = 7;

/// Steps until GL is needed or the time is up.
TradeSteps stepsOf(TradeRun& run, std::chrono::milliseconds time, bool onGl, Progress* progress)
{
    TradeSteps steps;
    const Clock::time_point start = Clock::now();
    do {
        const Result<bool> more = run.step(progress);
        if (!more) {
            steps.problem = more.error().message;
            return steps;
        }
        steps.more = *more;
    } while (steps.more && run.nextUsesGl() == onGl && Clock::now() - start < time);
    steps.trade = std::make_shared<const Trade>(run.trade());
    return steps;
}

void giveUp(Session& session)
{
    Trades& trades = session.trades;
    trades.steps.cancel();
    trades.picture.cancel();
    trades.map.cancel();
    trades.terms.cancel();
    trades.recheck.cancel();
    session.state.trade.running = false;
}

void measureTerms(Session& session, const Scene& scene, const RenderSettings& settings)
{
    session.state.trade.measuringTerms = true;
    session.trades.terms.start(
        [scene, settings](Progress& progress) { return termBars(scene, settings, termRepetitions, &progress); });
}

/// The view as the window would draw it at rest.
RenderSettings viewSettings(const Session& session)
{
    RenderSettings view = session.viewport.settings;
    view.samplesPerAxis = session.state.preferences.samplesPerAxis; // also while the camera's motion shows fewer
    return measuredSettings(view);
}

/// The terms by themselves, where the page asks for them.
void keepTerms(Session& session)
{
    TradeStudy& study = session.state.trade;
    if (std::exchange(study.termsAsked, false) && !study.running)
        measureTerms(session, shownScene(session.state), viewSettings(session));
    if (auto terms = session.trades.terms.take())
        study.terms = std::make_shared<const TermBars>(*std::move(terms));
    study.measuringTerms = session.trades.terms.busy();
}

void begin(Session& session)
{
    giveUp(session);
    Trades& trades = session.trades;
    TradeStudy& study = session.state.trade;
    trades.scene = shownScene(session.state);
    trades.settings = viewSettings(session);
    TradeOptions options;
    options.metric = study.metric;
    GlRenderer* gl = studyRenderer(session);
    trades.run = std::make_unique<TradeRun>(trades.scene, trades.settings, options, gl);
    trades.laid = {};
    trades.mappedTolerance = -1.0;
    study.running = true;
    study.done = 0.0;
    study.trade.reset();
    study.map.reset();
    study.terms.reset();
    study.selected.reset();
    study.problem.clear();
}

void takeSteps(Session& session, TradeSteps steps)
{
    TradeStudy& study = session.state.trade;
    if (!steps.problem.empty()) {
        study.problem = steps.problem;
        study.running = false;
        return;
    }
    study.trade = std::move(steps.trade);
    study.done = session.trades.run->done();
    study.running = steps.more;
    if (!steps.more)
        measureTerms(session, session.trades.scene, session.trades.settings);
}

void goOn(Session& session)
{
    Trades& trades = session.trades;
    if (auto steps = trades.steps.take())
        takeSteps(session, *std::move(steps));
    if (!session.state.trade.running || trades.steps.busy())
        return;
    if (trades.run->nextUsesGl())
        takeSteps(session, stepsOf(*trades.run, hold, true, nullptr));
    else
        trades.steps.start([run = trades.run.get()](Progress& progress) -> std::optional<TradeSteps> {
            TradeSteps steps = stepsOf(*run, batch, false, &progress);
            return progress.cancel ? std::nullopt : std::optional(std::move(steps));
        });
}

/// Whether the choice still holds once the scene has changed: asked when the picture rests and nothing else is measured.
void keepRechecking(Session& session)
{
    Trades& trades = session.trades;
    TradeStudy& study = session.state.trade;
    const std::uint64_t picture = session.viewport.pictures;
    if (trades.recheckedPicture != picture) {
        trades.recheck.cancel();
        study.rechecked.reset();
    }
    if (const auto error = trades.recheck.take())
        study.rechecked = error->by(study.metric);
    study.rechecking = trades.recheck.busy();
    const bool rests = session.trust.rested && !trustIsBusy(session) && !session.prices.busy();
    const auto shown = study.shown();
    if (!study.stale || study.running || !shown || !rests || trades.recheckedPicture == picture ||
        session.state.preferences.workbenchPage != "trade")
        return;
    trades.recheckedPicture = picture;
    study.rechecking = true;
    trades.recheck.start([scene = shownScene(session.state), settings = trades.settings,
                          recipe = study.trade->candidates[*shown].recipe](Progress& progress) {
        return recheckedOn(scene, settings, recipe, &progress);
    });
}

/// The map for the tolerance of now, when its page wants it.
void keepMap(Session& session)
{
    Trades& trades = session.trades;
    TradeStudy& study = session.state.trade;
    if (auto map = trades.map.take())
        study.map = std::make_shared<const SufficientMap>(*std::move(map));
    study.mapping = trades.map.busy();
    const bool wanted = study.overlay == TradeOverlay::Map && study.trade && !study.running && !study.stale;
    if (!wanted || study.holdsTolerance || study.mapping ||
        (trades.mappedTolerance == study.tolerance && trades.mappedMetric == study.metric))
        return;
    trades.mappedTolerance = study.tolerance;
    trades.mappedMetric = study.metric;
    trades.map.start([scene = trades.scene, settings = trades.settings, tolerance = study.tolerance,
                      metric = study.metric](Progress& progress) {
        return sufficientModels(scene, settings, tolerance, metric, &progress);
    });
    study.mapping = true;
}

void layPicture(Session& session, const Image& picture)
{
    Trades& trades = session.trades;
    if (trades.pictureOf.kind == TradeOverlay::Picture) {
        const Developed developed = develop(picture, trades.scene.sensor);
        trades.overlay.show(developed.width, developed.height, developed.rgb);
    } else {
        const Image& truth = trades.run->judge()->truth();
        const double largest = session.state.trade.trade->candidates[*trades.pictureOf.candidate].error.max;
        trades.overlay.show(picture.width, picture.height, differenceMap(truth, picture, std::max(largest, 1e-9)));
    }
    trades.laid = trades.pictureOf;
}

/// Makes the picture of a candidate: GL's at once, the CPU's on a thread.
void askForPicture(Session& session, const TradeLaid& wanted)
{
    Trades& trades = session.trades;
    trades.pictureOf = wanted;
    const Recipe& recipe = session.state.trade.trade->candidates[*wanted.candidate].recipe;
    const auto make = [run = trades.run.get(), recipe]() -> std::optional<Image> {
        const auto prepared = run->workshop().prepare(recipe);
        if (!prepared)
            return std::nullopt;
        const auto image = run->workshop().picture(*prepared);
        return image ? std::optional(*image) : std::nullopt;
    };
    if (recipe.onGl()) {
        if (const auto image = make())
            layPicture(session, *image);
        return;
    }
    trades.picture.start([make](Progress& /*progress*/) { return make(); });
}

void keepOverlay(Session& session)
{
    Trades& trades = session.trades;
    TradeStudy& study = session.state.trade;
    if (const auto image = trades.picture.take())
        layPicture(session, *image);
    if (study.overlay == TradeOverlay::None || !study.trade || study.running || study.stale || session.state.lens)
        return;
    if (study.overlay == TradeOverlay::Map) {
        const TradeLaid wanted{TradeOverlay::Map, {}, trades.mappedTolerance};
        if (study.map && !study.mapping && trades.laid != wanted) {
            trades.overlay.show(study.map->width, study.map->height, painted(*study.map));
            trades.laid = wanted;
        }
    } else if (const auto shown = study.shown()) {
        const TradeLaid wanted{study.overlay, shown, 0.0};
        if (trades.laid != wanted && !(trades.picture.busy() && trades.pictureOf == wanted))
            askForPicture(session, wanted);
    }
    if (trades.laid.kind == study.overlay)
        session.viewport.overlay = trades.overlay.id();
}

} // namespace

void pollTrade(Session& session)
{
    TradeStudy& study = session.state.trade;
    if (std::exchange(study.stopped, false))
        giveUp(session);
    if (std::exchange(study.asked, false))
        begin(session);
    keepTerms(session);
    if (!session.trades.run)
        return;
    study.stale = !looksTheSame(shownScene(session.state), session.trades.scene);
    if (study.running && study.stale)
        giveUp(session); // what would be measured now is no longer what is seen
    goOn(session);
    keepRechecking(session);
    keepMap(session);
    keepOverlay(session);
}

} // namespace reflectance::explorer
