#include "app/explorer/ui/workbench/curves_page.h"

#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/plot.h"
#include "app/explorer/ui/widgets.h"
#include "core/math/angle.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

constexpr float controlsWidth = 236.0F;

template <class Value, std::size_t count> void choose(const char* id, const Choice (&choices)[count], Value& value)
{
    ImGui::PushID(id);
    const int pressed = choiceRow(choices, static_cast<int>(value));
    if (pressed >= 0)
        value = static_cast<Value>(pressed);
    ImGui::PopID();
}

void angleRow(CurvesPage& page, std::optional<Message>& message)
{
    NumberRow row;
    row.name = "theta_i";
    row.symbol = "\u03B8_i";
    row.label = "Light";
    row.unit = "\u00B0";
    row.about = "Angle between the normal N and the direction L to the light. L, V and R lie in one plane.";
    row.sliderMax = 89.0;
    row.legalMin = 0.0;
    row.legalMax = 89.999;
    row.initial = 40.0;
    numberRow(row, page.thetaI, message);
}

void unitRows(CurveSettings& settings)
{
    static constexpr Choice quantities[] = {
        {"factor",
         "The lecture's factor: \u03C0 f cos \u03B8_i, intensity per intensity of the light, cosine included."},
        {"f",
         "The BRDF f in 1/sr: radiance per irradiance. It rises towards grazing light for models without the cosine."},
        {"f cos", "f cos \u03B8_i in 1/sr: radiance for a light of unit irradiance at normal incidence."}};
    static constexpr Choice channels[] = {{"mean", "Mean of red, green and blue for white light."},
                                          {"R", "Red sensor."},
                                          {"G", "Green sensor."},
                                          {"B", "Blue sensor."}};
    static constexpr Choice scales[] = {
        {"linear", "Values on a linear axis."},
        {"log", "Values on a logarithmic axis: the flanks of highlights become visible."}};
    choose("quantity", quantities, settings.quantity);
    choose("channel", channels, settings.shown);
    choose("scale", scales, settings.scale);
}

void overlayMenu(ExplorerState& state)
{
    std::vector<std::string>& overlays = state.curves.overlays;
    ImGui::SetNextItemWidth(-1);
    const std::string shown =
        overlays.empty() ? "Lay others over it\u2026" : std::to_string(overlays.size()) + " laid over";
    const bool open = beginMenu("##overlays", shown.c_str());
    if (!open) {
        tooltip("Other models of the catalogue in the same plot, with the parameters that the scene keeps for them.");
        return;
    }
    for (const Model& model : catalogue()) {
        const auto found = std::find(overlays.begin(), overlays.end(), model.id());
        const bool on = found != overlays.end();
        if (ImGui::Selectable(model.text.name.c_str(), on, ImGuiSelectableFlags_DontClosePopups)) {
            if (on)
                overlays.erase(found);
            else
                overlays.push_back(model.id());
        }
        tooltip(model.text.about);
    }
    ImGui::EndCombo();
}

void exportRow(ExplorerState& state, const Chart& chart)
{
    const float width = (ImGui::GetContentRegionAvail().x - points(4)) / 2;
    if (ImGui::Button("Save SVG", {width, 0}))
        state.requests.push_back({Request::Kind::SaveText, "curves.svg", svgOf(chart, 900, 480)});
    tooltip("The plot over \u03B8_r as a drawing, into the pictures folder.");
    ImGui::SameLine(0, points(4));
    if (ImGui::Button("Save CSV", {width, 0}))
        state.requests.push_back({Request::Kind::SaveText, "curves.csv", csvOf(chart)});
    tooltip("The numbers of the plot, into the pictures folder.");
}

} // namespace

std::vector<NamedSurface> shownSurfaces(const ExplorerState& state)
{
    std::vector<NamedSurface> surfaces;
    const auto add = [&](const Model& model) {
        surfaces.push_back({model.text.name, seriesColor(surfaces.size()), &model,
                            flatValues(model.text, state.scene.surface.values),
                            lookUpsIn(state.scene.surface.table.get())});
    };
    add(modelOf(state.scene));
    for (const std::string& id : state.curves.overlays)
        if (id != state.scene.surface.model)
            if (const auto model = findModel(id))
                add(**model);
    return surfaces;
}

void drawCurvesPage(ExplorerState& state)
{
    CurvesPage& page = state.curves;
    page.settings.thetaI = radians(page.thetaI);
    const std::vector<NamedSurface> surfaces = shownSurfaces(state);
    const Chart chart = overTheta(surfaces, page.settings);

    ImGui::BeginChild("controls", {points(controlsWidth), 0}, false, ImGuiWindowFlags_NavFlattened);
    angleRow(page, state.message);
    unitRows(page.settings);
    overlayMenu(state);
    exportRow(state, chart);
    ImGui::EndChild();
    ImGui::SameLine();

    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool both = room.x > points(460);
    if (both) {
        const float width = std::min(1.7F * room.y, 0.5F * room.x);
        drawPlot("polar", aboutThePoint(surfaces, page.settings), {width, room.y});
        ImGui::SameLine();
    }
    drawPlot("cartesian", chart, ImGui::GetContentRegionAvail());
}

} // namespace reflectance::explorer
