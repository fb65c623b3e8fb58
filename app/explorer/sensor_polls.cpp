#include "app/explorer/sensor_polls.h"

#include "app/explorer/ui/workbench/page.h"

#include <imgui.h>

#include <cmath>
#include <string_view>
#include <utility>

namespace reflectance::explorer {
namespace {

void readUnderMouse(Session& session)
{
    session.state.pixel.reset();
    const Viewport& viewport = session.viewport;
    if (!session.trust.rested || !viewport.hovered || viewport.dragging())
        return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Cursor cursor = viewport.view.cursorAt(mouse.x, mouse.y);
    session.state.pixel = readingOf(session.trust.rested->drawn.linear, session.state.scene.sensor,
                                    static_cast<int>(std::floor(cursor.x)), static_cast<int>(std::floor(cursor.y)));
}

void pollWaterfall(Session& session)
{
    SensorStudy& study = session.state.sensorStudy;
    const WorkbenchPage* page = openPage(session.state);
    const bool wanted = page != nullptr && std::string_view(page->id) == "sensor";
    const std::shared_ptr<const Rested>& rested = session.trust.rested;
    if (!rested) {
        session.waterfall.cancel();
        session.waterfallAsked.reset();
    } else if (wanted && rested != session.waterfallAsked) {
        session.waterfallAsked = rested;
        session.waterfall.start(
            [rested](Progress& progress) { return windowWaterfall(rested->scene, rested->drawn, progress); });
    }
    if (std::optional<Waterfall> found = session.waterfall.take())
        study.waterfall = std::move(found);
    study.running = session.waterfall.busy();
}

void pollObjectPrice(Session& session)
{
    ColourPage& page = session.state.colour;
    ObjectStudy& study = page.object;
    if (study.asked && session.trust.rested && page.answer) {
        study.asked = false;
        const Rested& rested = *session.trust.rested;
        session.objectPrices.start([question = ObjectQuestion{rested.scene, rested.drawn.samples, page.answer->system,
                                                              page.answer->patches[page.patch], page.answer->light}](
                                       Progress& progress) { return objectPrices(question, progress); });
    }
    if (std::optional<ObjectPrices> found = session.objectPrices.take())
        study.found = std::move(found);
    study.running = session.objectPrices.busy();
    study.done = session.objectPrices.done();
}

} // namespace

void pollSensorStudy(Session& session)
{
    readUnderMouse(session);
    pollWaterfall(session);
    pollObjectPrice(session);
}

} // namespace reflectance::explorer
