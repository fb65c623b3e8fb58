#include "app/explorer/ui/workbench/laboratory_page.h"

#include "app/explorer/ui/angle_rows.h"
#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/parameter_rows.h"
#include "app/explorer/ui/savable_plot.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/write.h"
#include "core/study/goniometer/checkpoint.h"
#include "core/study/goniometer/lobe_charts.h"
#include "core/study/goniometer/micro_surface.h"

#include <imgui_stdlib.h>

namespace reflectance::explorer {

namespace {

constexpr float setupWidth = 288.0F, resultWidth = 250.0F, narrowWidth = 262.0F;

void surfaceRows(LabWish& wish)
{
    ImGui::SetNextItemWidth(-1);
    if (beginMenu("##kind", "Micro-surface")) {
        for (const SurfaceKind& kind : surfaceKinds()) {
            if (ImGui::Selectable(kind.name))
                wish.surface = kind.initial;
            tooltip(kind.about);
        }
        ImGui::EndCombo();
    } else {
        tooltip("Kinds of micro-surfaces; the line below says exactly which one, and can be changed.");
    }
    ImGui::SetNextItemWidth(-1);
    ImGui::InputText("##surface", &wish.surface);
    tooltip("The micro-surface: vgrooves:sigma=30, vgrooves:slope=35, gaussian:sigma=20,correlation=0.05, "
            "scratches:..., flat; "
            "a picture of heights, FILE.png:height=0.1; or a mesh patch. Angles in degrees.");
}

bool canBeFacets(const Model& model)
{
    return !model.text.usesLightSize && !model.text.usesTable;
}

void facetsMenu(ExplorerState& state)
{
    LabWish& wish = state.lab.wish;
    const auto current = findModel(wish.model);
    const float button = points(66);
    ImGui::SetNextItemWidth(-button - points(4));
    if (beginMenu("##facets", ("Facets: " + (current ? (*current)->text.name : wish.model)).c_str())) {
        for (const Model& model : catalogue()) {
            if (!canBeFacets(model))
                continue;
            if (ImGui::Selectable(model.text.name.c_str(), model.id() == wish.model))
                wish.model = model.id();
            tooltip(model.text.about);
        }
        ImGui::EndCombo();
    } else {
        tooltip("The model of every single facet, about the facet's own normal.");
    }
    ImGui::SameLine(0, points(4));
    const bool possible = canBeFacets(modelOf(state.scene));
    ImGui::BeginDisabled(!possible);
    if (ImGui::Button("As scene", {button, 0})) {
        wish.model = state.scene.surface.model;
        wish.values = state.scene.surface.values;
    }
    ImGui::EndDisabled();
    tooltip(possible ? "Gives the facets the scene's surface: its model, with all parameters, K included."
                     : "The scene's surface is a mirror or a measured table, which facets cannot be.");
}

/// Numbers as they are, colours as one number for all channels; a matrix comes from the scene.
void facetsRows(ExplorerState& state)
{
    LabWish& wish = state.lab.wish;
    const auto model = findModel(wish.model);
    if (!model)
        return;
    for (const Parameter& parameter : (*model)->text.parameters) {
        const bool isColor = parameter.kind == ParameterKind::Color;
        if (!isColor && parameter.kind != ParameterKind::Number)
            continue;
        std::vector<double> values = valueOf(parameter, wish.values);
        if (numberRow(rowOf(parameter, 0), values[0], state.message)) {
            values.assign(isColor ? 3 : 1, values[0]);
            wish.values.insert_or_assign(parameter.name, std::move(values));
        }
    }
}

void effortRows(ExplorerState& state)
{
    LabWish& wish = state.lab.wish;
    NumberRow bounces;
    bounces.name = "bounces";
    bounces.label = "Interreflections";
    bounces.about = "Most reflections from facet to facet before the one to the viewer; 0: single reflection.";
    bounces.sliderMax = 20.0;
    bounces.legalMin = 0.0;
    bounces.legalMax = mostBounces;
    bounces.initial = 3.0;
    if (numberRow(bounces, wish.bounces, state.message))
        wish.bounces = std::round(wish.bounces);
    NumberRow error;
    error.name = "error";
    error.label = "Error";
    error.about = "The run ends when no cell's standard error is larger than this share of the root mean square of f. "
                  "Half the error takes four times as long.";
    error.sliderMin = 0.001;
    error.sliderMax = 0.1;
    error.logarithmic = true;
    error.legalMin = 1e-5;
    error.legalMax = 1.0;
    error.initial = 0.01;
    numberRow(error, wish.error, state.message);
}

void startRow(LabStudy& study)
{
    if (study.running) {
        if (ImGui::Button("Stop"))
            study.stopped = true;
        tooltip("Stops here. What was measured stays, and can go on later.");
        ImGui::SameLine();
        ImGui::ProgressBar(static_cast<float>(study.done), {-1, 0});
        tooltip("Of the paths that are planned so far; cells with large errors then get more.");
        return;
    }
    const bool goesOn = study.canGoOn();
    if (ImGui::Button(goesOn ? "Go on" : "Measure", {-1, 0}))
        study.asked = true;
    tooltip(goesOn ? "Goes on with this run until the error is reached: the same numbers as without a stop."
                   : "Traces the micro-surface from all lighting and viewing directions, with masking, shadowing and "
                     "interreflection, until the error is reached.");
}

std::string stateOf(const LabRun& run)
{
    const LabErrors errors = errorsFound(run);
    return general(static_cast<double>(run.paths()), 3) + " paths in " + std::to_string(run.cells.size()) +
           " cells; error " + general(100.0 * errors.typical, 2) + " % typically, " +
           general(100.0 * errors.largest, 2) + " % at most";
}

void useRows(ExplorerState& state, const LabRun& run)
{
    const float width = (ImGui::GetContentRegionAvail().x - points(4)) / 2;
    const auto ask = [&](Request::Kind kind, const char* name, std::string text) {
        state.requests.push_back({kind, name, std::move(text)});
    };
    if (ImGui::Button("Show on the object", {width, 0}))
        ask(Request::Kind::OpenText, "laboratory.csv", csvText(tableOf(run)));
    tooltip("Saves the table into the pictures folder and gives it to the scene's surface.");
    ImGui::SameLine(0, points(4));
    if (ImGui::Button("Fit Oren-Nayar", {width, 0}))
        ask(Request::Kind::FitText, "laboratory.csv", csvText(tableOf(run)));
    tooltip("Saves the table, and searches rho and sigma of Oren-Nayar's model with which it comes nearest: see the "
            "page Fit.");
    if (ImGui::Button("Save table", {width, 0})) {
        ask(Request::Kind::SaveText, "laboratory_errors.csv", csvText(errorsOf(run)));
        ask(Request::Kind::SaveText, "laboratory.csv", csvText(tableOf(run)));
    }
    tooltip("f in 1/sr and its standard errors, two tables in CSV, into the pictures folder.");
    ImGui::SameLine(0, points(4));
    if (ImGui::Button("Save run", {width, 0}))
        ask(Request::Kind::SaveText, "laboratory.lab", checkpointText(run));
    tooltip("The run itself, for 'reflectance goniometer --resume FILE.lab --out TABLE.csv'.");
}

void incidenceRow(ExplorerState& state)
{
    incidenceRow(
        {"Angle between N and the light in the plots; the nearest one that is measured is shown.", 80.0, 90.0, 60.0},
        state.lab.thetaI, state.message);
}

void drawResult(ExplorerState& state, const LabRun& run)
{
    incidenceRow(state);
    useRows(state, run);
    remark(stateOf(run));
}

/// Setup, and beside it the result; in a narrow window below it.
void drawControls(ExplorerState& state, const LabRun* run)
{
    LabStudy& study = state.lab;
    const bool beside = ImGui::GetContentRegionAvail().x > points(setupWidth + resultWidth + 200.0F);
    ImGui::BeginChild("setup", {points(beside ? setupWidth : narrowWidth), 0}, false, ImGuiWindowFlags_NavFlattened);
    scrollBarTooltip("More controls above and below.");
    ImGui::BeginDisabled(study.running);
    surfaceRows(study.wish);
    facetsMenu(state);
    facetsRows(state);
    effortRows(state);
    ImGui::EndDisabled();
    startRow(study);
    if (!study.problem.empty())
        remark(study.problem, palette::error);
    if (run && !beside)
        drawResult(state, *run);
    ImGui::EndChild();
    ImGui::SameLine();
    if (!run || !beside)
        return;
    ImGui::BeginChild("result", {points(resultWidth), 0}, false, ImGuiWindowFlags_NavFlattened);
    scrollBarTooltip("More about this run above and below.");
    drawResult(state, *run);
    ImGui::EndChild();
    ImGui::SameLine();
}

/// The scene's surface beside what was traced, where it is a formula.
std::vector<NamedFactor> formulasOf(const Scene& scene)
{
    const Model& model = modelOf(scene);
    if (!canBeFacets(model))
        return {};
    return {{"the scene's " + model.text.name, factorOf(model, flatValues(model.text, scene.surface.values))}};
}

} // namespace

void drawLaboratoryPage(ExplorerState& state)
{
    const std::shared_ptr<const LabRun> run = state.lab.run; // a newer one may come while this is drawn
    drawControls(state, run.get());
    if (!run)
        return remark("Choose a micro-surface and what its facets are made of, and measure: rays go from every viewer "
                      "to the facets "
                      "and on to the light. The lobe fills in while you watch.");
    const std::size_t incidence = nearestIncidence(run->setup, radians(state.lab.thetaI));
    const std::vector<NamedFactor> formulas = formulasOf(state.scene);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool both = room.x > points(560);
    const float width = both ? 0.5F * room.x : room.x;
    savablePlot("lobe", lobeChart(*run, "traced", incidence, formulas), {width, room.y}, state, !both);
    if (!both)
        return;
    ImGui::SameLine();
    savablePlot("plane", planeChart(*run, "traced", incidence, formulas), ImGui::GetContentRegionAvail(), state);
}

} // namespace reflectance::explorer
