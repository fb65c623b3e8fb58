#include "app/explorer/ui/workbench/losses_table.h"

#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/widgets.h"

namespace reflectance::explorer {

namespace {

struct Column {
    const char* name;
    float width; ///< points; 0: shares what is left
    const char* about;
};

constexpr Column columns[] = {
    {"model", 110, "The model of the catalogue."},
    {"what moves", 0, "What the sweep carries from harmless to extreme."},
    {"in", 56, "The arithmetic; GLSL on this driver."},
    {"textbook", 120, "Where pow(max(R.V, 0), n), v / sqrt(v.v) and the like first lose three digits."},
    {"here", 120,
     "Where this program first loses three digits. Equal to the textbook, it is N, L and V that are rounded."},
};

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
        tooltip(column.about);
    }
}

void cell(const std::string& text, ImU32 color = palette::quiet)
{
    ImGui::TableNextColumn();
    remark(elided(text, ImGui::GetContentRegionAvail().x), color);
}

std::string pointText(const std::optional<double>& point, double last)
{
    return point ? written(*point, 3) : "none up to " + written(last, 1);
}

} // namespace

void drawLossesTable(std::span<const SweepRow> rows)
{
    if (!ImGui::BeginTable("losses", static_cast<int>(std::size(columns)),
                           ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
        return;
    drawHeader();
    for (const SweepRow& row : rows) {
        ImGui::TableNextRow();
        cell(row.model, palette::accent);
        cell(row.swept, palette::text);
        cell(row.arithmetic);
        cell(pointText(row.textbook, row.last), row.textbook ? palette::warning : palette::good);
        cell(pointText(row.ours, row.last), row.ours ? palette::text : palette::good);
    }
    ImGui::EndTable();
}

} // namespace reflectance::explorer
