#include "app/explorer/ui/parameter_rows.h"

#include "app/explorer/ui/list_rows.h"
#include "app/explorer/ui/matrix_editor.h"
#include "app/explorer/ui/widgets.h"

#include <array>

namespace reflectance::explorer {

namespace {

std::vector<double> currentValues(const ParameterValues& values, const Parameter& parameter)
{
    const auto found = values.find(parameter.name);
    return found == values.end() ? parameter.initial : found->second;
}

bool colorRow(const Parameter& parameter, std::vector<double>& values, const std::vector<FormulaPiece>& formula,
              ExplorerState& state)
{
    constexpr std::array<const char*, 3> channels = {"red", "green", "blue"};
    rowLabel(parameter.symbol, parameter.label);
    const float gap = points(4);
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    bool changed = false;
    for (std::size_t i = 0; i < 3; ++i) {
        NumberRow row = rowOf(parameter, i);
        row.name += channels[i];
        row.label += std::string(", ") + channels[i];
        row.formula = formula;
        changed |= numberField(row, values[i], width, state.message);
        if (i < 2)
            ImGui::SameLine(0, gap);
    }
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
    ParameterValues& kept = state.scene.surface.values;
    std::vector<double> values = currentValues(kept, parameter);
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
