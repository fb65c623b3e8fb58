#include "app/explorer/ui/workbench/extremes_page.h"

#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/hazards_table.h"
#include "app/explorer/ui/workbench/losses_table.h"

#include <algorithm>
#include <initializer_list>

namespace reflectance::explorer {

namespace {

std::string summaryText(const ExtremesSummary& summary)
{
    std::string text = std::to_string(summary.passed) + " pass";
    const auto append = [&text](std::size_t count, const char* what) {
        if (count > 0)
            text += ", " + std::to_string(count) + what;
    };
    append(summary.failed, " FAIL");
    append(summary.notYet, " not yet");
    append(summary.notRun, " not run");
    return text;
}

void drawRun(ExtremesStudy& study, ExtremesPage& page)
{
    if (study.running) {
        if (ImGui::Button("Stop"))
            study.running = false;
        tooltip("Stop here; what has been found stays.");
        ImGui::SameLine();
        ImGui::ProgressBar(study.done(), {points(120), 0});
        tooltip("Hazards and sweeps tried so far.");
        return;
    }
    if (ImGui::Button(study.findings.empty() ? "Run all" : "Run again")) {
        study.start();
        page.selected.reset();
    }
    tooltip("Tries every hazard in double, float, SIMD and this driver's GLSL.");
}

/// Beside the last item where `width` fits there, else below it.
void besideOrBelow(float width)
{
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + points(12) + width <= right)
        ImGui::SameLine(0, points(12));
}

float widthOfButtons(std::initializer_list<const char*> labels)
{
    float width = 0.0F;
    for (const char* label : labels)
        width += sizeIn(Face::Body, label).x + 2 * ImGui::GetStyle().FramePadding.x + points(2);
    return width;
}

/// Which table, and which of its rows.
void drawChoices(ExtremesPage& page)
{
    besideOrBelow(widthOfButtons({"Hazards", "Where digits go"}));
    if (toggleButton("Hazards", !page.losses))
        page.losses = false;
    tooltip("The hazards H01 to H74, row by row. Click a row to see its case.");
    ImGui::SameLine(0, points(2));
    if (toggleButton("Where digits go", page.losses))
        page.losses = true;
    tooltip("The first exponent, angle or length at which each model loses three digits, as a textbook writes it and "
            "here.");
    if (page.losses)
        return;
    besideOrBelow(widthOfButtons({"Only failures"}));
    if (toggleButton("Only failures", page.onlyFailures))
        page.onlyFailures = !page.onlyFailures;
    tooltip("Leave out what passed, does not apply, or could not run.");
}

void drawHead(ExplorerState& state)
{
    drawRun(state.extremes, state.extremesPage);
    if (state.extremes.findings.empty()) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        remark("47 inputs at which reflectance code gives NaN, wrong digits, or a highlight brighter than its light.");
        return;
    }
    drawChoices(state.extremesPage);
    besideOrBelow(points(60));
    ImGui::AlignTextToFramePadding();
    const std::string summary = summaryText(summaryOf(state.extremes.findings));
    remark(elided(summary, ImGui::GetContentRegionAvail().x), palette::text, Face::Body);
}

/// The selected row in full.
void drawDetail(const ExplorerState& state)
{
    const auto& [onlyFailures, losses, selected] = state.extremesPage;
    if (!selected || *selected >= state.extremes.findings.size())
        return;
    const Finding& finding = state.extremes.findings[*selected];
    ImGui::BeginChild("detail", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
    remark(finding.id + "  " + finding.danger + ", " + finding.arithmetic + ".  In: " + finding.input, palette::text);
    remark("Expected: " + finding.expected);
    remark("Found: " + finding.found, finding.verdict == Verdict::Fail ? palette::error : palette::text);
    ImGui::EndChild();
}

} // namespace

void drawExtremesPage(ExplorerState& state)
{
    drawHead(state);
    if (state.extremes.findings.empty())
        return;
    if (state.extremesPage.losses) {
        drawLossesTable(state.extremes.losses);
        return;
    }
    drawHazardsTable(state);
    drawDetail(state);
}

} // namespace reflectance::explorer
