#include "app/explorer/ui/workbench/table_page.h"

#include "app/explorer/ui/angle_rows.h"
#include "app/explorer/ui/savable_plot.h"
#include "app/explorer/ui/table_rows.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

constexpr float controlsWidth = 236.0F;

bool choose(const char* id, std::span<const Choice> choices, int current, int& chosen)
{
    ImGui::PushID(id);
    const int pressed = choiceRow(choices, current);
    ImGui::PopID();
    if (pressed < 0 || pressed == current)
        return false;
    chosen = pressed;
    return true;
}

/// Which number of a colour or of a matrix.
bool channelRows(const Table& table, TableMapSettings& settings)
{
    if (table.channels == 1)
        return false;
    static constexpr Choice rows[] = {{"mean", "Mean of the three channels (of the matrix's diagonal)."},
                                      {"R", "What the red sensor sees."},
                                      {"G", "What the green sensor sees."},
                                      {"B", "What the blue sensor sees."}};
    static constexpr Choice columns[] = {{"of R", "Of the red light primary."},
                                         {"of G", "Of the green light primary."},
                                         {"of B", "Of the blue light primary."}};
    int chosen = 0;
    bool changed = choose("row", rows, settings.row + 1, chosen);
    if (changed) {
        settings.row = chosen - 1;
        settings.column = std::max(0, settings.row);
    }
    if (table.channels == 9 && settings.row >= 0 && choose("column", columns, settings.column, chosen)) {
        settings.column = chosen;
        changed = true;
    }
    return changed;
}

bool whatRows(TablePage& page)
{
    static constexpr Choice what[] = {
        {"values", "The measured f in 1/sr."},
        {"reciprocity",
         "f(i,r) \u2212 f(r,i): what exchanging light and viewer changes. A reciprocal surface is grey all over."}};
    static constexpr Choice scales[] = {{"linear", "Values on a linear scale."},
                                        {"log", "Values on a logarithmic scale."}};
    int chosen = 0;
    bool changed = choose("what", what, page.residual ? 1 : 0, chosen);
    if (changed)
        page.residual = chosen == 1;
    if (!page.residual && choose("scale", scales, page.settings.logarithmic ? 1 : 0, chosen)) {
        page.settings.logarithmic = chosen == 1;
        changed = true;
    }
    return changed;
}

void drawFacts(const std::optional<TableFacts>& facts)
{
    if (!facts) {
        remark("Measuring reciprocity and interpolation\u2026");
        return;
    }
    remark("Reciprocity up to " + general(reciprocityLimit, 3) +
           "\u00B0: " + general(100.0 * facts->reciprocity.rms, 3) + " % rms, worst " +
           general(100.0 * facts->reciprocity.worst, 3) + " % of the largest f");
    for (const LeftOut& along : facts->leftOut)
        remark("Left out along " + along.along + ": " + general(100.0 * along.rms, 3) + " % rms");
}

/// The light goes where the clicked cell is met.
void light(ExplorerState& state, const TableCursor& cursor, double deltaPhi)
{
    const int selected = state.selectedLight;
    if (selected < 0 || selected >= static_cast<int>(state.scene.lights.size()))
        return;
    Light& light = state.scene.lights[static_cast<std::size_t>(selected)];
    const Vec3d L = lightFor(state.scene.camera, cursor, deltaPhi);
    light.direction = L;
    light.position = length(light.position) * L;
}

void drawPlots(ExplorerState& state)
{
    TablePage& page = state.tablePage;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool both = room.x > points(460);
    const float width = both ? std::min(1.35F * room.y, 0.56F * room.x) : room.x;
    const PlotHover hover = savablePlot("table", page.map, {width, room.y}, state);
    if (hover.inside) {
        page.cursor = {std::clamp(hover.y, 0.0, 89.9), std::clamp(hover.x, 0.0, 89.9)};
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            light(state, page.cursor, page.settings.deltaPhi);
    }
    if (!both)
        return;
    ImGui::SameLine();
    savablePlot("slice", polarSlice(page.shown->table, page.cursor.thetaI, page.settings),
                ImGui::GetContentRegionAvail(), state);
}

} // namespace

void drawTablePage(ExplorerState& state)
{
    TablePage& page = state.tablePage;
    const std::shared_ptr<const MeasuredTable>& table = state.scene.surface.table;
    ImGui::BeginChild("controls", {points(controlsWidth), 0}, false, ImGuiWindowFlags_NavFlattened);
    bool changed = false;
    if (table) {
        changed |= whatRows(page);
        changed |= azimuthRow(page.settings.deltaPhi, state.message);
        changed |= channelRows(table->table, page.settings);
        drawFacts(page.facts);
        remark("A click on the map moves the selected light: a point that is tilted \u03B8_r from you, to the right, "
               "is then "
               "lit at \u03B8_i.");
    } else {
        tableChooser(state);
        remark("Open a measurement, or drop one on the window: CSV, MERL, RGL, Cornell, Zemax, CUReT, OpenMATERIAL. "
               "'reflectance table sample' makes one of any model.");
    }
    ImGui::EndChild();
    renewMap(page, table, changed);
    if (!table)
        return;
    ImGui::SameLine();
    drawPlots(state);
}

} // namespace reflectance::explorer
