#include "app/explorer/ui/list_rows.h"

#include "app/explorer/ui/parameter_rows.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/reflectance/lists.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

/// "l2_n4_m2" reads better as "l2 n4 m2".
std::string spaced(std::string name)
{
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

void choose(const ModelText& model, const Parameter& choice, double chosen, ParameterValues& values)
{
    const ParameterValues before = valuesByName(model, flatValues(model, values));
    values.insert_or_assign(choice.name, std::vector<double>{chosen});
    for (const Parameter& list : model.parameters)
        if (list.chosenBy == choice.name)
            values.insert_or_assign(list.name, inForm(list, before.at(list.name), *list.formFor(chosen)));
}

NumberRow rowOfNumber(const Parameter& list, const ListForm& form, std::size_t i)
{
    NumberRow row = rowOf(list, 0);
    row.name = list.name + " " + form.names[i];
    row.label = spaced(form.names[i]);
    row.initial = inForm(list, list.initial, form)[i];
    return row;
}

} // namespace

void choiceRows(const ModelText& model, const Parameter& choice, ExplorerState& state)
{
    ParameterValues& values = surfaceInHand(state.compare, state.scene).values;
    const double now = flatValues(model, values)[choice.offset];
    std::vector<std::string> labels;
    for (const double value : choice.choices)
        labels.push_back(shortest(value));
    std::vector<Choice> buttons;
    for (const std::string& label : labels)
        buttons.push_back({label.c_str(), choice.tooltip.c_str()});
    const auto at = std::find(choice.choices.begin(), choice.choices.end(), now) - choice.choices.begin();
    ImGui::PushID(choice.name.c_str());
    rowLabel(choice.symbol, choice.label);
    const int pressed = choiceRow(buttons, static_cast<int>(at));
    ImGui::PopID();
    if (pressed >= 0 && pressed != at)
        choose(model, choice, choice.choices[static_cast<std::size_t>(pressed)], values);
}

void listRows(const ModelText& model, const Parameter& list, ExplorerState& state)
{
    if (!fold(list.label.c_str(), list.tooltip.c_str()))
        return;
    ParameterValues& values = surfaceInHand(state.compare, state.scene).values;
    const ListForm* form = formOf(model, list, values);
    if (!form)
        return;
    std::vector<double> numbers = valuesByName(model, flatValues(model, values)).at(list.name);
    bool changed = false;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        changed |= numberRow(rowOfNumber(list, *form, i), numbers[i], state.message);
    if (changed)
        values.insert_or_assign(list.name, std::move(numbers));
}

} // namespace reflectance::explorer
