#include "app/explorer/ui/parameter_rows.h"

#include "app/explorer/ui/list_rows.h"
#include "app/explorer/ui/matrix_editor.h"
#include "app/explorer/ui/widgets.h"

#include <array>

namespace reflectance::explorer {

namespace {

constexpr std::array<const char*, 3> channels = {"red", "green", "blue"};

/// Switches between one number for all channels and three; three become their mean.
bool channelsButton(std::vector<double>& values, bool& three, float width)
{
    ImGui::SameLine(0, points(4));
    ImGui::PushFont(face(Face::Small));
    const bool pressed = toggleButton("RGB", three, {width, ImGui::GetFrameHeight()});
    ImGui::PopFont();
    tooltip(three ? "Red, green and blue apart. Press for one number, their mean."
                  : "One number for red, green and blue. Press to set them apart.");
    if (!pressed)
        return false;
    const bool differ = values[0] != values[1] || values[1] != values[2];
    if (differ)
        values.assign(3, (values[0] + values[1] + values[2]) / 3);
    three = !three;
    return differ;
}

/// One slider while the three numbers are the same, unless three were asked for.
bool colorRow(const Parameter& parameter, std::vector<double>& values, const std::vector<FormulaPiece>& formula,
              ExplorerState& state)
{
    rowLabel(parameter.symbol, parameter.label);
    ImGui::PushID(parameter.name.c_str());
    bool& asked = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("three"), false);
    bool three = asked || values[0] != values[1] || values[1] != values[2];
    const float gap = points(4);
    const float button = points(38);
    const float fields = ImGui::GetContentRegionAvail().x - button - gap;
    bool changed = false;
    NumberRow row = rowOf(parameter, 0);
    row.formula = formula;
    if (!three && numberField(row, values[0], fields, state.message)) {
        values.assign(3, values[0]);
        changed = true;
    }
    for (std::size_t i = 0; i < 3 && three; ++i) {
        row = rowOf(parameter, i);
        row.name += channels[i];
        row.label += std::string(", ") + channels[i];
        row.formula = formula;
        changed |= numberField(row, values[i], (fields - 2 * gap) / 3, state.message);
        if (i < 2)
            ImGui::SameLine(0, gap);
    }
    changed |= channelsButton(values, three, button);
    asked = three;
    ImGui::PopID();
    return changed;
}

bool numberRowOf(const Parameter& parameter, std::vector<double>& values, const std::vector<FormulaPiece>& formula,
                 ExplorerState& state)
{
    NumberRow row = rowOf(parameter, 0);
    row.formula = formula;
    return numberRow(row, values[0], state.message);
}

} // namespace

NumberRow rowOf(const Parameter& parameter, std::size_t i)
{
    NumberRow row;
    row.name = parameter.name;
    row.symbol = parameter.symbol;
    row.label = parameter.label;
    row.unit = parameter.unit;
    row.about = parameter.tooltip;
    row.source = parameter.source;
    row.sliderMin = parameter.sliderMin;
    row.sliderMax = parameter.sliderMax;
    row.logarithmic = parameter.logarithmic;
    row.legalMin = parameter.legalMin;
    row.legalMax = parameter.legalMax;
    row.initial = parameter.initial[i];
    return row;
}

void parameterRows(const ModelText& model, const Parameter& parameter, ExplorerState& state)
{
    if (parameter.kind == ParameterKind::Choice)
        return choiceRows(model, parameter, state);
    if (parameter.kind == ParameterKind::List)
        return listRows(model, parameter, state);
    ParameterValues& kept = surfaceInHand(state.compare, state.scene).values;
    std::vector<double> values = valueOf(parameter, kept);
    bool changed = false;
    if (parameter.kind == ParameterKind::Matrix) {
        changed = matrixEditor(parameter, values, state);
    } else {
        const std::vector<FormulaPiece> formula = typeset(model.formula, model.parameters);
        changed = parameter.kind == ParameterKind::Color ? colorRow(parameter, values, formula, state)
                                                         : numberRowOf(parameter, values, formula, state);
    }
    if (changed)
        kept.insert_or_assign(parameter.name, std::move(values));
}

} // namespace reflectance::explorer
