#include "app/explorer/ui/workbench/trade_page.h"

#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/trade_views.h"
#include "core/base/text.h"
#include "core/study/trade/trade_page.h"

#include <algorithm>

namespace reflectance::explorer {
namespace {

constexpr float controlsWidth = 250.0F, detailWidth = 320.0F;

void runRow(TradeStudy& study)
{
    if (study.running) {
        if (ImGui::Button("Stop"))
            study.stopped = true;
        tooltip("Stop here; what has been measured stays.");
        ImGui::SameLine();
        ImGui::ProgressBar(static_cast<float>(study.done), {-1, 0});
        tooltip("Candidates examined and timed so far.");
        return;
    }
    if (ImGui::Button(study.trade ? "Measure again" : "Measure this view", {-1, 0}))
        study.asked = true;
    tooltip(
        "Draws this view in every cheaper way, alone and combined, and holds each against the double picture with 64 "
        "samples per pixel. Do not touch the machine meanwhile: what else it does shows in the times.");
}

void metricRow(TradeStudy& study)
{
    static constexpr Choice metrics[] = {
        {"max", "The largest difference of any linear channel of any pixel; white is 1."},
        {"rmse", "Root mean square over all linear channels of the picture."},
        {"dE", "dE2000 that 95 of 100 of the object's pixels stay below: what an eye sees."}};
    ImGui::PushID("metric");
    const int pressed = choiceRow(metrics, static_cast<int>(study.metric));
    ImGui::PopID();
    if (pressed < 0)
        return;
    study.metric = static_cast<Metric>(pressed);
    study.tolerance = study.metric == Metric::DeltaE ? 1.0 : 0.02;
    if (study.trade) { // the same measurements, looked at by another figure
        auto turned = std::make_shared<Trade>(*study.trade);
        turned->metric = study.metric;
        markFront(*turned);
        study.trade = std::move(turned);
    }
}

NumberRow budgetRow()
{
    NumberRow row;
    row.name = row.label = "Budget";
    row.unit = std::string("ms");
    row.about = "Milliseconds that shading again may take.";
    row.logarithmic = true;
    row.legalMin = 1e-12;
    row.sliderMin = 0.1;
    row.sliderMax = 1000.0;
    row.initial = 5.0;
    return row;
}

NumberRow toleranceRow(Metric metric)
{
    const bool isDeltaE = metric == Metric::DeltaE;
    NumberRow row;
    row.name = row.label = "Tolerance";
    row.about =
        "The largest error that is good enough, by the figure chosen above. The line in the chart can be dragged.";
    row.logarithmic = true;
    row.legalMin = 1e-12;
    row.sliderMin = isDeltaE ? 1e-3 : 1e-6;
    row.sliderMax = isDeltaE ? 100.0 : 1.0;
    row.initial = isDeltaE ? 1.0 : 0.02;
    return row;
}

void dialRows(TradeStudy& study, std::optional<Message>& message)
{
    static constexpr Choice dials[] = {{"error \u2264", "The cheapest candidate that is at least so exact."},
                                       {"time \u2264", "The most exact candidate that takes no longer."}};
    ImGui::PushID("dial");
    if (const int pressed = choiceRow(dials, study.byTime ? 1 : 0); pressed >= 0) {
        study.byTime = pressed == 1;
        study.selected.reset();
    }
    ImGui::PopID();
    const NumberRow row = study.byTime ? budgetRow() : toleranceRow(study.metric);
    if (numberRow(row, study.byTime ? study.milliseconds : study.tolerance, message))
        study.selected.reset();
}

void candidateMenu(TradeStudy& study)
{
    if (!study.trade)
        return;
    const auto shown = study.shown();
    const std::string name = shown ? nameOf(study.trade->candidates[*shown].recipe) : "none meets that";
    ImGui::SetNextItemWidth(-1);
    if (!beginMenu("##candidate", name.c_str())) {
        tooltip("The candidates on the front, by falling error. A dot in the chart can be clicked as well.");
        return;
    }
    for (const std::size_t i : frontOf(*study.trade)) {
        const Candidate& candidate = study.trade->candidates[i];
        if (ImGui::Selectable((nameOf(candidate.recipe) + "##" + std::to_string(i)).c_str(), shown == i))
            study.selected = i;
        tooltip(sentenceOf(*study.trade, candidate));
    }
    ImGui::EndCombo();
}

void overlayRow(TradeStudy& study)
{
    static constexpr Choice overlays[] = {{"view", "The view as it is drawn."},
                                          {"picture", "The candidate's picture, in the place of the view."},
                                          {"difference",
                                           "Candidate minus truth in luminance: blue is darker, red brighter, full "
                                           "colour at its largest error."},
                                          {"map", "Each pixel in the colour of the cheapest surface that is within the "
                                                  "tolerance there."}};
    ImGui::PushID("overlay");
    if (const int pressed = choiceRow(overlays, static_cast<int>(study.overlay)); pressed >= 0)
        study.overlay = static_cast<TradeOverlay>(pressed);
    ImGui::PopID();
}

/// What is known of the choice on the changed scene.
void staleRemark(const TradeStudy& study)
{
    if (study.rechecking)
        return remark("The scene has changed; the choice is being checked on it.", palette::warning);
    if (!study.rechecked)
        return remark("The scene has changed since; measure again.", palette::warning);
    const bool holds = study.byTime || *study.rechecked <= study.tolerance;
    remark("The scene has changed: the choice is now off by " + general(*study.rechecked, 3) +
               (study.byTime ? "."
                : holds      ? ", still within."
                             : ", beyond the tolerance; measure again."),
           holds ? palette::text : palette::warning);
}

void drawControls(ExplorerState& state)
{
    TradeStudy& study = state.trade;
    ImGui::BeginChild("controls", {points(controlsWidth), 0}, false, ImGuiWindowFlags_NavFlattened);
    runRow(study);
    metricRow(study);
    dialRows(study, state.message);
    candidateMenu(study);
    overlayRow(study);
    if (study.stale && study.trade)
        staleRemark(study);
    else if (study.mapping)
        remark("The map is being made.");
    ImGui::EndChild();
}

void drawFindings(const TradeStudy& study)
{
    for (const std::string& finding : findingsOf(*study.trade, study.wanted()))
        remark(finding, palette::text);
    for (const SkippedRung& skipped : study.trade->skipped)
        remark(skipped.rung + ": " + skipped.why);
    remark(std::to_string(study.trade->settings.width) + "x" + std::to_string(study.trade->settings.height) + ", " +
           sentenceOf(study.trade->machine));
}

void drawDetail(TradeStudy& study)
{
    ImGui::BeginChild("detail", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
    static constexpr Choice details[] = {{"candidate", "Error, cost and what is given up."},
                                         {"terms", "What each term of the picture buys and costs."},
                                         {"findings", "What the measurement says, and what does not apply here."}};
    ImGui::PushID("details");
    if (const int pressed = choiceRow(details, static_cast<int>(study.detail)); pressed >= 0)
        study.detail = static_cast<TradeDetail>(pressed);
    ImGui::PopID();
    if (study.overlay == TradeOverlay::Map && study.map)
        drawMapLegend(*study.map);
    if (study.detail == TradeDetail::Candidate)
        drawTradeCandidate(study);
    else if (study.detail == TradeDetail::Terms)
        drawTradeTerms(study);
    else
        drawFindings(study);
    ImGui::EndChild();
}

} // namespace

void drawTradePage(ExplorerState& state)
{
    TradeStudy& study = state.trade;
    drawControls(state);
    ImGui::SameLine();
    if (!study.problem.empty())
        return remark(study.problem, palette::error, Face::Body);
    if (!study.trade || study.trade->candidates.empty())
        return remark(study.running
                          ? "The truth is being drawn: double, 64 samples per pixel."
                          : "Every way of drawing this view more cheaply - arithmetic, K, model, shading place, "
                            "samples, resolution, lights - as a dot: what it costs and how far it is from the truth. "
                            "A click shows its picture.");
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float plotWidth = std::max(points(160), room.x - points(detailWidth));
    drawTradeChart(state, {plotWidth, room.y});
    ImGui::SameLine();
    drawDetail(study);
}

} // namespace reflectance::explorer
