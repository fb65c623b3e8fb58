#include "app/explorer/ui/surface_panel.h"

#include "app/explorer/ui/card.h"
#include "app/explorer/ui/formula_view.h"
#include "app/explorer/ui/parameter_rows.h"
#include "app/explorer/ui/rung_row.h"
#include "app/explorer/ui/table_rows.h"
#include "app/explorer/ui/variant_rows.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/study/exports/export_model.h"

#include <algorithm>
#include <array>

namespace reflectance::explorer {

namespace {

void modelTooltip(const ModelText& model)
{
    if (!tooltipIsDue())
        return;
    // Beside the menu, so that the other models stay in sight, and within the window.
    const float y = ImGui::GetMousePos().y;
    ImGui::SetNextWindowPos({ImGui::GetWindowPos().x - points(6), y}, ImGuiCond_Always,
                            {1.0F, y / ImGui::GetIO().DisplaySize.y});
    beginTooltip();
    ImGui::PushFont(face(Face::Strong));
    ImGui::TextUnformatted(model.name.c_str());
    ImGui::PopFont();
    drawFormula(typeset(model.formula, model.parameters), points(320));
    ImGui::TextUnformatted(model.about.c_str());
    remark(model.citation);
    endTooltip();
}

/// A line of the menu: name and formula, as one selectable.
bool modelLine(const ModelText& model, bool current)
{
    const ImVec2 start = ImGui::GetCursorPos();
    const float height = points(46);
    ImGui::PushID(model.id.c_str());
    const bool chosen = ImGui::Selectable("##model", current, 0, {0, height});
    modelTooltip(model);
    const ImVec2 after = ImGui::GetCursorPos();
    ImGui::SetCursorPos({start.x + points(6), start.y + points(3)});
    ImGui::PushFont(face(Face::Strong));
    ImGui::TextUnformatted(model.name.c_str());
    ImGui::PopFont();
    ImGui::SetCursorPos({start.x + points(6), start.y + points(21)});
    // The menu shows the first part of the formula; where R and the like are defined stands below the menu, and all of it
    // under the mouse.
    const float width = points(360);
    drawFormula(formulaWithin(typeset(model.formula.substr(0, model.formula.find(",  ")), model.parameters), width),
                width);
    ImGui::SetCursorPos(after);
    if (current)
        ImGui::SetItemDefaultFocus();
    ImGui::PopID();
    return chosen;
}

void modelMenu(ExplorerState& state)
{
    Surface& surface = surfaceInHand(state.compare, state.scene);
    const Model& current = modelOf(surface);
    rowLabel("", "Model");
    const bool open = beginMenu("##model menu", current.text.name.c_str());
    if (open) {
        std::string_view family;
        if (surface.own) {
            remark("Your own", palette::accent);
            if (modelLine(surface.own->text, surface.own.get() == &current))
                surface.model = surface.own->id();
        }
        for (const Model& model : catalogue()) {
            if (model.text.family != family)
                remark(model.text.family, palette::accent);
            family = model.text.family;
            if (modelLine(model.text, &model == &current))
                surface.model = model.id();
        }
        ImGui::EndCombo();
    } else {
        modelTooltip(current.text);
    }
}

constexpr std::array<Choice, 2> variants = {{
    {"A", "The panel changes variant A.  X"},
    {"B", "The panel changes variant B.  X"},
}};

/// Which of the two compared surfaces the controls below change.
void variantSwitch(ExplorerState& state)
{
    rowLabel("", "Variant");
    const float gap = points(4);
    const float swap = sizeIn(Face::Body, "Swap").x + points(16);
    const float copy = sizeIn(Face::Body, "B = A").x + points(16);
    ImGui::BeginChild("##variants",
                      {ImGui::GetContentRegionAvail().x - swap - copy - 2 * gap, ImGui::GetFrameHeight()});
    const int pressed = choiceRow(variants, state.compare.handOnB ? 1 : 0);
    if (pressed >= 0)
        state.compare.handOnB = pressed == 1;
    ImGui::EndChild();
    ImGui::SameLine(0, gap);
    if (ImGui::Button("Swap", {swap, 0}))
        swapVariants(state.scene);
    tooltip("A becomes B and B becomes A.");
    ImGui::SameLine(0, gap);
    if (ImGui::Button("B = A", {copy, 0}))
        state.scene.other = state.scene.surface;
    tooltip("B becomes a copy of A.");
}

void drawProperty(const char* name, const DeclaredProperty& property, const char* meaning)
{
    const std::string text = std::string(property.holds ? "\u2713 " : "\u2717 ") + name;
    remark(text, property.holds ? palette::good : palette::warning);
    tooltip(std::string(meaning) + (property.holds ? " This model: yes" : " This model: no") +
            (property.reason.empty() ? "." : ", " + property.reason + "."));
}

void drawFormulaBlock(const ModelText& model)
{
    drawFormula(typeset(model.formula, model.parameters), ImGui::GetContentRegionAvail().x);
    tooltip(model.about);
    drawProperty("reciprocal", model.reciprocal, "Reciprocal: exchanging light and viewer leaves the BRDF as it is.");
    ImGui::SameLine(0, points(14));
    drawProperty("passive", model.passive, "Passive: no more light leaves than arrives.");
    ImGui::SameLine(0, points(14));
    if (!model.nonnegative.holds) {
        drawProperty("never negative", model.nonnegative, "Never negative: no light is taken away.");
        ImGui::SameLine(0, points(14));
    }
    ImGui::PushFont(face(Face::Small));
    const std::string citation = elided(model.citation, ImGui::GetContentRegionAvail().x);
    ImGui::PopFont();
    remark(citation);
    tooltip(model.citation);
}

std::string kept(const ParameterValues::value_type& entry)
{
    std::vector<std::string> numbers;
    for (const double number : entry.second)
        numbers.push_back(general(number, 4));
    return entry.first + " = " + joined(numbers, " ");
}

/// Values that belong to other models: they come back with them.
void drawKeptValues(const ModelText& model, const ParameterValues& values)
{
    const auto isForeign = [&](const auto& entry) { return model.find(entry.first) == nullptr; };
    if (std::none_of(values.begin(), values.end(), isForeign))
        return;
    const bool open =
        fold("Kept for other models", "Values that this model does not use. They come back with a model that does.");
    for (const auto& entry : values)
        if (open && isForeign(entry))
            remark(kept(entry));
}

/// The surface in hand as code and as a table for other programs.
void exportButton(ExplorerState& state)
{
    const Surface& surface = surfaceInHand(state.compare, state.scene);
    const Model& model = modelOf(surface);
    if (ImGui::Button("Export as GLSL, C++ and CSV", {-1, 0}))
        for (const ExportFormFacts& form : exportForms()) {
            const auto text = exported(
                {&model, flatValues(model.text, surface.values), lookUpsIn(surface.table.get()), surface.tableFile},
                form.form);
            if (text)
                state.requests.push_back(
                    {Request::Kind::SaveText, model.id() + std::string(form.ending), text.value()});
            else
                state.message = Message{text.error().sentence(), true};
        }
    tooltip("The model with these parameters as a GLSL function, a C++17 header and a table, into the pictures folder. "
            "Each "
            "carries test vectors with what double gives and a tolerance, and the code checks itself by them.");
}

} // namespace

void drawSurfacePanel(ExplorerState& state)
{
    const Card card({2, "Surface", modelOf(surfaceInHand(state.compare, state.scene)).text.name,
                     "The reflectance model: how much of the light from L leaves towards V."});
    if (!card.isOpen())
        return;
    if (state.compare.on)
        variantSwitch(state);
    modelMenu(state);
    const ModelText& model = modelOf(surfaceInHand(state.compare, state.scene)).text;
    drawFormulaBlock(model);
    ImGui::Dummy({0, points(2)});
    if (model.usesTable)
        tableRows(state);
    for (const Parameter& parameter : model.parameters)
        parameterRows(model, parameter, state);
    drawKeptValues(model, surfaceInHand(state.compare, state.scene).values);
    rungRow(state);
    variantRows(state);
    exportButton(state);
}

} // namespace reflectance::explorer
