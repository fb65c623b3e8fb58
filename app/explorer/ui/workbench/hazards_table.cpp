#include "app/explorer/ui/workbench/hazards_table.h"

#include "app/explorer/ui/widgets.h"

#include <algorithm>
#include <array>

namespace reflectance::explorer {

namespace {

struct Column {
    const char* name;
    float width; ///< points; 0: shares what is left
    const char* about;
};

constexpr Column columns[] = {
    {"id", 40, "H01 to H74, by theme."},
    {"hazard", 0, "What can go wrong."},
    {"in", 54, "The arithmetic that was tried; GLSL on this driver. - where no model computes."},
    {"expected", 0, "What must come out: closed forms in angles, exact figures or published ones."},
    {"found", 0, "What came out in this run."},
    {"verdict", 60, "pass, FAIL, not yet (the model does not exist here), or not run (no OpenGL)."},
};

std::string textOf(const Finding& finding, int column)
{
    switch (column) {
    case 0:
        return finding.id;
    case 1:
        return finding.danger;
    case 2:
        return finding.arithmetic;
    case 3:
        return finding.expected;
    case 4:
        return finding.found;
    default:
        return std::string(nameOf(finding.verdict));
    }
}

ImU32 colorOf(const Finding& finding, int column)
{
    if (column == 5)
        return finding.verdict == Verdict::Pass   ? palette::good
               : finding.verdict == Verdict::Fail ? palette::error
                                                  : palette::quiet;
    return column == 0 ? palette::accent : column == 1 || column == 4 ? palette::text : palette::quiet;
}

void drawHeader()
{
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const Column& column : columns)
        ImGui::TableSetupColumn(column.name, column.width > 0 ? ImGuiTableColumnFlags_WidthFixed : 0,
                                column.width > 0 ? points(column.width) : 1.0F);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const Column& column : columns) {
        ImGui::TableNextColumn();
        ImGui::TableHeader(column.name);
        tooltip(std::string(column.about) + " Click to sort.");
    }
}

void drawRow(ExplorerState& state, std::size_t index)
{
    const Finding& finding = state.extremes.findings[index];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(index));
    const bool chosen =
        ImGui::Selectable("##row", state.extremesPage.selected == index, ImGuiSelectableFlags_SpanAllColumns);
    tooltip(finding.danger + "\nin  " + finding.input + "\nexpected  " + finding.expected + "\nfound  " +
            finding.found + "\nClick, or press Space, to see the case in the picture.");
    ImGui::PopID();
    ImGui::SameLine(0, 0);
    for (int column = 0; column < static_cast<int>(std::size(columns)); ++column) {
        if (column > 0)
            ImGui::TableNextColumn();
        remark(elided(textOf(finding, column), ImGui::GetContentRegionAvail().x), colorOf(finding, column));
    }
    if (chosen) {
        state.extremesPage.selected = index;
        showCase(state, finding);
    }
}

} // namespace

std::vector<std::size_t> shownFindings(const std::vector<Finding>& findings, bool onlyFailures, int column,
                                       bool descending)
{
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < findings.size(); ++i)
        if (!onlyFailures || findings[i].verdict == Verdict::Fail)
            shown.push_back(i);
    if (column >= 0)
        std::ranges::stable_sort(shown, [&](std::size_t a, std::size_t b) {
            const std::string left = textOf(findings[a], column), right = textOf(findings[b], column);
            return descending ? right < left : left < right;
        });
    return shown;
}

void drawHazardsTable(ExplorerState& state)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                      ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_Sortable |
                                      ImGuiTableFlags_SortTristate;
    const float detail = state.extremesPage.selected ? points(64) : 0.0F;
    if (!ImGui::BeginTable("hazards", static_cast<int>(std::size(columns)), flags, {0.0F, -detail}))
        return;
    drawHeader();
    const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
    const bool sorted = specs != nullptr && specs->SpecsCount > 0;
    const int column = sorted ? specs->Specs[0].ColumnIndex : -1;
    const bool descending = sorted && specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
    const std::vector<std::size_t> shown =
        shownFindings(state.extremes.findings, state.extremesPage.onlyFailures, column, descending);
    for (const std::size_t index : shown)
        drawRow(state, index);
    ImGui::EndTable();
}

} // namespace reflectance::explorer
