#include "app/explorer/plot_polls.h"

#include <utility>

namespace reflectance::explorer {
namespace {

void takeOver(Session& session)
{
    std::optional<PlotAnswer> answer = session.plots.take();
    if (!answer)
        return;
    CurvesPage& page = session.state.curves;
    const PlotTab tab = answer->question.tab;
    if (const BallStrip& strip = answer->balls; !strip.balls.empty()) {
        ScreenTexture& texture = session.plotTextures.try_emplace(tab, Window::loader()).first->second;
        texture.show(strip.size * static_cast<int>(strip.balls.size()), strip.size, developedStrip(strip));
        page.textures[tab] = texture.id();
    }
    page.answers[tab] = *std::move(answer);
}

} // namespace

void pollPlots(Session& session)
{
    CurvesPage& page = session.state.curves;
    takeOver(session);
    const std::optional<PlotQuestion> wish = std::exchange(page.wish, std::nullopt);
    const auto known = wish ? page.answers.find(wish->tab) : page.answers.end();
    const bool isKnown = known != page.answers.end() && known->second.question == *wish;
    if (wish && !isKnown && !session.plots.busy())
        session.plots.start([question = *wish](Progress& progress) { return answered(question, progress); });
    page.measuring = session.plots.busy();
    page.done = session.plots.done();
}

} // namespace reflectance::explorer
