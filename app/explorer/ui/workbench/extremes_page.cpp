#include "app/explorer/ui/workbench/extremes_page.h"

#include "app/explorer/ui/widgets.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

ImU32 colorOf(Verdict verdict)
{
    return verdict == Verdict::Pass ? palette::good : verdict == Verdict::Fail ? palette::error : palette::quiet;
}

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

void drawHead(ExtremesStudy& study)
{
    if (study.running) {
        if (ImGui::Button("Stop"))
            study.running = false;
        tooltip("Stop here; what has been found stays.");
        ImGui::SameLine();
        ImGui::ProgressBar(study.done(), {points(160), 0});
        tooltip("Hazards tried so far.");
    } else {
        if (ImGui::Button(study.findings.empty() ? "Run all" : "Run again"))
            study.start();
        tooltip("Tries every hazard in double, float, SIMD and this driver's GLSL.");
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    if (study.findings.empty())
        remark("47 inputs at which reflectance code gives NaN, wrong digits, or a highlight brighter than its light.");
    else
        remark(summaryText(summaryOf(study.findings)), palette::text, Face::Body);
}

void cell(const std::string& text, ImU32 color = palette::quiet)
{
    ImGui::TableNextColumn();
    remark(elided(text, ImGui::GetContentRegionAvail().x), color);
}

void drawRow(const Finding& finding)
{
    ImGui::TableNextRow();
    cell(finding.id, palette::accent);
    cell(finding.danger, palette::text);
    cell(finding.arithmetic);
    cell(finding.expected);
    cell(finding.found, palette::text);
    cell(std::string(nameOf(finding.verdict)), colorOf(finding.verdict));
}

} // namespace

void drawExtremesPage(ExplorerState& state)
{
    ExtremesStudy& study = state.extremes;
    drawHead(study);
    if (study.findings.empty())
        return;
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("hazards", 6, flags))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("id", ImGuiTableColumnFlags_WidthFixed, points(34));
    ImGui::TableSetupColumn("hazard", 0, 1.6F);
    ImGui::TableSetupColumn("in", ImGuiTableColumnFlags_WidthFixed, points(48));
    ImGui::TableSetupColumn("expected", 0, 1.6F);
    ImGui::TableSetupColumn("found", 0, 1.6F);
    ImGui::TableSetupColumn("verdict", ImGuiTableColumnFlags_WidthFixed, points(52));
    ImGui::TableHeadersRow();
    for (const Finding& finding : study.findings)
        drawRow(finding);
    ImGui::EndTable();
}

} // namespace reflectance::explorer
