#include "app/explorer/ui/workbench/fit_page.h"

#include "app/explorer/ui/angle_rows.h"
#include "app/explorer/ui/savable_plot.h"
#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/photograph_view.h"
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/study/fit/plane_chart.h"

#include <algorithm>
#include <imgui_stdlib.h>

namespace reflectance::explorer {

namespace {

constexpr float controlsWidth = 236.0F, numbersWidth = 300.0F;

void fileField(ExplorerState& state)
{
    FitWish& wish = state.fit.wish;
    const std::string& shown = state.scene.surface.tableFile;
    if (!shown.empty() && wish.file != shown) {
        if (ImGui::Button("The scene's table", {-1, 0}))
            wish.file = shown;
        tooltip("Fit to the measurement that the object wears: " + shown);
    }
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##file", "path of a measured table", &wish.file);
    tooltip("A measurement: CSV, OpenMATERIAL 3D, MERL, RGL, Cornell, CUReT or Zemax; the content decides.");
    ImGui::SetNextItemWidth(-1);
    ImGui::InputInt("##surface", &wish.surface, 1, 10);
    tooltip("Which surface of a file that holds several, such as CUReT's 61; 1 for all others.");
    wish.surface = std::max(1, wish.surface);
}

void pictureField(FitStudy& study)
{
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##picture", "path of a picture of this object", &study.pictureFile);
    study.readPicture |= ImGui::IsItemDeactivatedAfterEdit() && !study.pictureFile.empty();
    tooltip("A photograph or a render, PNG or EXR, of the scene's mesh from the scene's camera under the scene's "
            "lights. Click "
            "pixels in it to fit to those alone.");
    const std::size_t marks = study.wish.pixels.size();
    ImGui::BeginDisabled(marks == 0);
    if (ImGui::Button("All pixels", {-1, 0}))
        study.wish.pixels.clear();
    ImGui::EndDisabled();
    tooltip(marks == 0 ? "Every pixel that shows the object whole, lit and unclipped is fitted."
                       : "Forget the " + std::to_string(marks) + " marked pixels and fit to all.");
}

void modelMenu(FitWish& wish)
{
    const auto current = findModel(wish.model);
    ImGui::SetNextItemWidth(-1);
    const bool open = beginMenu("##model", current ? (*current)->text.name.c_str() : wish.model.c_str());
    if (!open) {
        tooltip(
            "The model whose parameters are searched. The scene's own surface changes only when you apply the fit.");
        return;
    }
    for (const Model& model : catalogue()) {
        if (ImGui::Selectable(model.text.name.c_str(), model.id() == wish.model))
            wish.model = model.id();
        tooltip(model.text.about);
    }
    ImGui::EndCombo();
}

bool chosen(const char* id, std::span<const Choice> choices, bool current)
{
    ImGui::PushID(id);
    const int pressed = choiceRow(choices, current ? 1 : 0);
    ImGui::PopID();
    return pressed >= 0 ? pressed == 1 : current;
}

void weightRows(FitWish& wish)
{
    static constexpr Choice weights[] = {{"linear", "Differences count as they are: highlights rule."},
                                         {"log", "Differences of logarithms: dark and bright angles count alike."}};
    static constexpr Choice quantities[] = {
        {"f", "The BRDF is compared: grazing angles count as much as others."},
        {"f cos", "f cos \u03B8_i is compared: each direction counts with the light that it brings."}};
    static constexpr Choice outliers[] = {
        {"all alike", "Every sample counts with its square: plain least squares."},
        {"held back", "Outliers count with their root only (Huber): one bad sample does not rule."}};
    wish.logarithmic = chosen("weights", weights, wish.logarithmic);
    wish.cosine = chosen("quantity", quantities, wish.cosine);
    wish.robust = chosen("outliers", outliers, wish.robust);
}

bool isReady(const FitWish& wish)
{
    return wish.fromPicture ? wish.photograph && wish.photograph->problem.empty() : !wish.file.empty();
}

void startRow(FitStudy& study)
{
    if (study.running) {
        if (ImGui::Button("Stop"))
            study.stopped = true;
        tooltip("Give this fit up; the last result stays.");
        ImGui::SameLine();
        ImGui::ProgressBar(static_cast<float>(study.done), {-1, 0});
        tooltip("Starts that have reached their minimum.");
        return;
    }
    ImGui::BeginDisabled(!isReady(study.wish));
    study.asked |= ImGui::Button("Fit", {-1, 0});
    ImGui::EndDisabled();
    tooltip("Searches the parameters with which the model comes nearest to what was seen.");
}

void drawNumbers(const FitResult& fit)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("numbers", 3, flags))
        return;
    ImGui::TableSetupColumn("parameter", 0, 1.4F);
    ImGui::TableSetupColumn("value", 0, 1.0F);
    ImGui::TableSetupColumn("\u00B1 standard error", 0, 1.4F);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const char* name : {"parameter", "value", "\u00B1 standard error"}) {
        ImGui::TableNextColumn();
        remark(name);
    }
    for (const FittedNumber& number : fit.numbers) {
        ImGui::TableNextColumn();
        remark(number.name, palette::text);
        ImGui::TableNextColumn();
        remark(general(number.value, 4), number.determined ? palette::text : palette::warning);
        ImGui::TableNextColumn();
        remark(number.atBound ? "at its bound" : "\u00B1 " + general(number.standardError, 2),
               number.atBound || !number.determined ? palette::warning : palette::quiet);
    }
    ImGui::EndTable();
}

void drawResult(const FitOutcome& outcome, ExplorerState& state)
{
    const std::string model = (*findModel(outcome.wish.model))->text.name;
    if (ImGui::Button(("Apply " + model).c_str(), {-1, 0}))
        applyFit(outcome, state.scene);
    tooltip("Gives the scene's surface this model and these parameters.");
    remark(general(100.0 * outcome.fit.relativeRms, 3) + " % relative RMS error, BIC " + general(outcome.fit.bic, 6),
           palette::text);
    tooltip("Root mean square of model minus measurement, over that of the measurement. BIC compares models on the "
            "same data: "
            "lower is better.");
    for (const std::string& warning : outcome.fit.warnings)
        remark(warning, palette::warning);
    drawNumbers(outcome.fit);
}

void incidenceRow(FitStudy& study, std::optional<Message>& message)
{
    incidenceRow({"Angle between N and the light in the plot. The fit itself looks at every sample.", 85.0, 89.0, 30.0},
                 study.thetaI, message);
}

void drawControls(ExplorerState& state)
{
    FitStudy& study = state.fit;
    static constexpr Choice sources[] = {
        {"measurement", "Fit to a measured table in a file."},
        {"picture", "Fit to the pixels of a photograph or a render of the scene's object."}};
    ImGui::BeginChild("controls", {points(controlsWidth), 0}, false, ImGuiWindowFlags_NavFlattened);
    study.wish.fromPicture = chosen("source", sources, study.wish.fromPicture);
    if (study.wish.fromPicture)
        pictureField(study);
    else
        fileField(state);
    modelMenu(study.wish);
    weightRows(study.wish);
    startRow(study);
    if (study.outcome && study.outcome->problem.empty() && !study.wish.fromPicture)
        incidenceRow(study, state.message);
    ImGui::EndChild();
}

void drawCurve(ExplorerState& state, const FitOutcome& outcome)
{
    const FitStudy& study = state.fit;
    const Model& model = **findModel(outcome.wish.model);
    savablePlot("fit",
                chartInPlane(outcome.measurement, model, flatValues(model.text, outcome.fit.values),
                             radians(study.thetaI), outcome.wish.cosine),
                ImGui::GetContentRegionAvail(), state);
}

} // namespace

void applyFit(const FitOutcome& outcome, Scene& scene)
{
    scene.surface.model = outcome.wish.model;
    for (const auto& [name, numbers] : outcome.fit.values)
        scene.surface.values.insert_or_assign(name, numbers);
}

void drawFitPage(ExplorerState& state)
{
    drawControls(state);
    ImGui::SameLine();
    const std::shared_ptr<const FitOutcome> outcome = state.fit.outcome; // a new one may come while this is drawn
    const bool isShown = outcome && outcome->problem.empty() && outcome->wish.fromPicture == state.fit.wish.fromPicture;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float width = std::max(points(120), room.x - points(numbersWidth));
    ImGui::BeginChild("seen", {width, 0}, false, ImGuiWindowFlags_NavFlattened);
    if (state.fit.wish.fromPicture)
        drawPhotograph(state.fit, ImGui::GetContentRegionAvail());
    else if (isShown)
        drawCurve(state, *outcome);
    else
        remark("Name a measured file, choose a model, and fit. The curve then lies over the data, and one click gives "
               "the scene's surface what was found.");
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("result", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
    if (isShown)
        drawResult(*outcome, state);
    else if (outcome && !outcome->problem.empty())
        remark(outcome->problem, palette::error, Face::Body);
    ImGui::EndChild();
}

} // namespace reflectance::explorer
