#include "app/explorer/ui/workbench/curves_controls.h"

#include "app/explorer/ui/angle_rows.h"
#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/widgets.h"
#include "core/math/angle.h"

#include <algorithm>
#include <numbers>

namespace reflectance::explorer {

namespace {

template <class Value, std::size_t count> void choose(const char* id, const Choice (&choices)[count], Value& value)
{
    ImGui::PushID(id);
    const int pressed = choiceRow(choices, static_cast<int>(value));
    if (pressed >= 0)
        value = static_cast<Value>(pressed);
    ImGui::PopID();
}

/// The angle, and whether it is the selected light's own.
void angleRows(ExplorerState& state)
{
    CurvesPage& page = state.curves;
    const std::optional<double> ofLight = lightAngle(state);
    page.linked = page.linked && ofLight.has_value();
    if (page.linked)
        page.thetaI = std::min(*ofLight, 89.999);
    constexpr IncidenceRow limits{
        "Angle between the normal N and the direction L to the light. L, V and R lie in one plane.", 89.0, 89.999,
        40.0};
    if (incidenceRow(limits, page.thetaI, state.message) && page.linked)
        setLightAngle(state, page.thetaI);
    ImGui::BeginDisabled(!ofLight);
    if (toggleButton("Linked to the scene's light", page.linked, {-1, 0}))
        page.linked = !page.linked;
    ImGui::EndDisabled();
    tooltip(
        "\u03B8_i is that of the selected light at the probed point (click the object), else where the surface faces "
        "you: dragging the light moves the curves, and the slider moves the light.");
}

void quantityRow(CurveSettings& settings)
{
    static constexpr Choice quantities[] = {
        {"factor",
         "The lecture's factor: \u03C0 f cos \u03B8_i, intensity per intensity of the light, cosine included."},
        {"f",
         "The BRDF f in 1/sr: radiance per irradiance. It rises towards grazing light for models without the cosine."},
        {"f cos", "f cos \u03B8_i in 1/sr: radiance for a light of unit irradiance at normal incidence."}};
    choose("quantity", quantities, settings.quantity);
}

void channelRow(CurveSettings& settings)
{
    static constexpr Choice channels[] = {{"mean", "Mean of red, green and blue for white light."},
                                          {"R", "Red sensor."},
                                          {"G", "Green sensor."},
                                          {"B", "Blue sensor."}};
    choose("channel", channels, settings.shown);
}

void scaleRow(CurveSettings& settings)
{
    static constexpr Choice scales[] = {
        {"linear", "Values on a linear axis."},
        {"log", "Values on a logarithmic axis: the flanks of highlights become visible."}};
    choose("scale", scales, settings.scale);
}

bool overlayLine(const ModelText& model, std::vector<std::string>& overlays)
{
    const auto found = std::find(overlays.begin(), overlays.end(), model.id);
    const bool on = found != overlays.end();
    const bool pressed = ImGui::Selectable(model.name.c_str(), on, ImGuiSelectableFlags_DontClosePopups);
    tooltip(model.about.empty() ? model.name : model.about);
    if (pressed && on)
        overlays.erase(found);
    else if (pressed)
        overlays.push_back(model.id);
    return pressed;
}

void overlayMenu(ExplorerState& state)
{
    std::vector<std::string>& overlays = state.curves.overlays;
    ImGui::SetNextItemWidth(-1);
    const std::string shown =
        overlays.empty() ? "Lay others over it\u2026" : std::to_string(overlays.size()) + " laid over";
    const bool open = beginMenu("##overlays", shown.c_str());
    if (!open) {
        tooltip("Other models of the catalogue, or your own, in the same plot, with the parameters that the scene "
                "keeps for "
                "them.");
        return;
    }
    if (const auto& own = state.scene.surface.own)
        overlayLine(own->text, overlays);
    for (const Model& model : catalogue())
        overlayLine(model.text, overlays);
    ImGui::EndCombo();
}

void viewRows(LobeView& view, std::optional<Message>& message)
{
    static constexpr Choice looks[] = {{"net", "Lobes as nets of lines: one is seen through the other."},
                                       {"filled", "Lobes as solid shapes."}};
    choose("look", looks, view.filled);
    const float width = (ImGui::GetContentRegionAvail().x - points(4)) / 2;
    const auto turn = [&](const char* name, const char* about, double least, double most, double initial,
                          double& radiant) {
        NumberRow row;
        row.name = name;
        row.unit = "\u00B0";
        row.about = about;
        row.sliderMin = row.legalMin = least;
        row.sliderMax = row.legalMax = most;
        row.initial = initial;
        double value = degrees(radiant);
        if (numberField(row, value, width, message))
            radiant = radians(value);
    };
    view.azimuth = std::remainder(view.azimuth, 2.0 * std::numbers::pi);
    turn("turn", "Turns the lobes about the normal. A drag in the plot does the same.", -180.0, 180.0, -34.0,
         view.azimuth);
    ImGui::SameLine(0, points(4));
    turn("tilt", "How far above the surface you stand. A drag in the plot does the same.", -90.0, 90.0, 29.0,
         view.elevation);
}

void wedgeRows(ExplorerState& state)
{
    CurvesPage& page = state.curves;
    const ModelText& model = modelOf(state.scene).text;
    const Parameter* current = wedgeParameter(page, model);
    ImGui::SetNextItemWidth(-1);
    if (!current) {
        remark("This model has no number to vary.");
        return;
    }
    const bool open = beginMenu("##parameter", (current->label + "  " + current->name).c_str());
    if (!open)
        tooltip("The parameter that varies from ball to ball, over its slider's range.");
    for (const Parameter* parameter : open ? wedgeParameters(model) : std::vector<const Parameter*>()) {
        if (ImGui::Selectable((parameter->label + "  " + parameter->name).c_str(), parameter == current))
            page.parameter = parameter->name;
        tooltip(parameter->tooltip);
    }
    if (open)
        ImGui::EndCombo();
    static constexpr Choice steps[] = {
        {"5", "Five balls."}, {"7", "Seven balls."}, {"9", "Nine balls."}, {"11", "Eleven balls."}};
    int chosen = (page.steps - 5) / 2;
    choose("steps", steps, chosen);
    page.steps = 5 + 2 * chosen;
}

} // namespace

void drawCurvesControls(ExplorerState& state)
{
    CurvesPage& page = state.curves;
    const PlotTab tab = page.tab;
    const bool aboutOneLight = tab == PlotTab::Curves || tab == PlotTab::Polar || tab == PlotTab::Lobe;
    if (aboutOneLight)
        angleRows(state);
    if (tab == PlotTab::Map)
        azimuthRow(page.deltaPhi, state.message);
    if (tab == PlotTab::Wedge)
        wedgeRows(state);
    if (aboutOneLight || tab == PlotTab::Map)
        quantityRow(page.settings);
    channelRow(page.settings);
    if (tab == PlotTab::Curves || tab == PlotTab::Map)
        scaleRow(page.settings);
    if (tab == PlotTab::Lobe)
        viewRows(page.view, state.message);
    if (tab != PlotTab::Map && tab != PlotTab::Wedge)
        overlayMenu(state);
    if (tab == PlotTab::Balls || tab == PlotTab::Wedge)
        remark("Lit by the scene's lights, without its surroundings, through its sensor.");
    if (tab == PlotTab::Albedo)
        remark("The share of a light's power that leaves, by quadrature over all viewers. The bars, and the reading, "
               "say how "
               "far two quadratures lie apart.");
    scrollBarTooltip("More controls above and below.");
}

} // namespace reflectance::explorer
