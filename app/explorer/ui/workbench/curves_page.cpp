#include "app/explorer/ui/workbench/curves_page.h"

#include "app/explorer/ui/lobe_plot.h"
#include "app/explorer/ui/savable_plot.h"
#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/balls_view.h"
#include "app/explorer/ui/workbench/curves_controls.h"
#include "core/math/angle.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

/// Less where the window is narrow: the plot needs it more.
float controlsWidth(float room)
{
    return std::clamp(0.42F * room, points(190), points(236));
}

void tabRow(PlotTab& tab)
{
    static constexpr Choice tabs[] = {
        {"Curves", "Over the viewer's angle in the plane of incidence, linear or logarithmic; polar beside it where "
                   "there is room."},
        {"Polar", "About the point, in the plane of incidence."},
        {"Lobe", "About the point, in space."},
        {"Balls", "A ball of each model, lit as the scene is."},
        {"Albedo", "What share of the light leaves, over the light's angle, with the error of the quadrature."},
        {"Wedge", "One parameter from the low to the high end of its slider, as a row of balls."},
        {"Map", "The current model over both angles."}};
    ImGui::PushID("tabs");
    const int pressed = choiceRow(tabs, static_cast<int>(tab));
    if (pressed >= 0)
        tab = static_cast<PlotTab>(pressed);
    ImGui::PopID();
}

void drawCurves(ExplorerState& state)
{
    const std::vector<NamedSurface> surfaces = named(plottedSurfaces(state));
    const CurveSettings& settings = state.curves.settings;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (state.curves.tab == PlotTab::Polar) {
        savablePlot("polar", aboutThePoint(surfaces, settings), room, state);
        return;
    }
    if (room.x > points(460)) {
        const float width = std::min(1.7F * room.y, 0.5F * room.x);
        savablePlot("polar", aboutThePoint(surfaces, settings), {width, room.y}, state);
        ImGui::SameLine();
    }
    savablePlot("curves", overTheta(surfaces, settings), ImGui::GetContentRegionAvail(), state);
}

void drawLobe(ExplorerState& state, const LobeChart& chart, ImVec2 room)
{
    LobeView& view = state.curves.view;
    ImGui::BeginGroup();
    plotHeading({"lobes", chart.title, [&] { return svgOf(chart, view, 700, 560); }, [&] { return csvOf(chart); }},
                room, state);
    drawLobes("lobes", chart, view, {room.x, room.y - plotHeadingHeight()});
    ImGui::EndGroup();
}

/// The last answer, while another is on its way.
void drawAnswer(ExplorerState& state)
{
    CurvesPage& page = state.curves;
    PlotQuestion question = questionOf(state);
    const auto found = page.answers.find(page.tab);
    const bool fresh = found != page.answers.end() && found->second.question == question;
    page.wish = std::move(question);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (found != page.answers.end()) {
        const PlotAnswer& answer = found->second;
        const auto texture = page.textures.find(page.tab);
        if (page.tab == PlotTab::Lobe)
            drawLobe(state, answer.lobes, room);
        else if (page.tab == PlotTab::Albedo)
            savablePlot("albedo", answer.albedo, room, state);
        else if (page.tab == PlotTab::Map)
            savablePlot("map", answer.map, room, state);
        else
            drawBalls(page.tab == PlotTab::Balls ? "balls" : "wedge", answer,
                      texture == page.textures.end() ? 0U : texture->second, room, state);
    }
    if (fresh)
        return;
    // A line that grows, so that nothing jumps when the answer is there.
    const auto share = static_cast<float>(page.measuring ? page.done : 0.0);
    ImGui::GetWindowDrawList()->AddRectFilled(
        corner, {corner.x + room.x * std::max(0.02F, share), corner.y + points(2)}, palette::accent);
}

} // namespace

void drawCurvesPage(ExplorerState& state)
{
    CurvesPage& page = state.curves;
    tabRow(page.tab);
    ImGui::BeginChild("controls", {controlsWidth(ImGui::GetContentRegionAvail().x), 0}, false,
                      ImGuiWindowFlags_NavFlattened);
    drawCurvesControls(state);
    ImGui::EndChild();
    page.settings.thetaI = radians(page.thetaI);
    ImGui::SameLine();
    if (page.tab == PlotTab::Curves || page.tab == PlotTab::Polar)
        drawCurves(state);
    else
        drawAnswer(state);
}

} // namespace reflectance::explorer
