#include "app/explorer/ui/table_rows.h"

#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <filesystem>

namespace reflectance::explorer {

namespace {

/// "90 x 90 x 181 half-difference angles, 3 channels"
std::string sizeOf(const Table& table)
{
    std::vector<std::string> counts;
    for (const auto& axis : table.axes)
        counts.push_back(std::to_string(axis.size()));
    return joined(counts, " \u00D7 ") + " " + std::string(nameOf(table.system)) + " angles, " +
           (table.channels == 1   ? "grey"
            : table.channels == 3 ? "three colours"
                                  : "a matrix");
}

/// Samples of the grid without a value.
std::size_t holesIn(const Table& table)
{
    std::size_t holes = 0;
    for (std::size_t i = 0; i < table.samples(); ++i)
        holes += table.isHole(i) ? 1U : 0U;
    return holes;
}

void drawFacts(const Table& table)
{
    const Provenance& source = table.provenance;
    remark(source.format + ": " + source.convention);
    remark(sizeOf(table) + ", looked up " + std::string(nameOf(table.interpolation)));
    if (const std::size_t holes = holesIn(table); holes > 0)
        remark(std::to_string(holes) + " of " + std::to_string(table.samples()) +
                   " samples were not measured: stripes on the object.",
               palette::warning);
    else
        remark("Nothing is extrapolated: beyond the measured angles the object wears stripes.");
    if (source.negatives > 0)
        remark(std::to_string(source.negatives) + " samples are negative, and kept.", palette::warning);
    for (const std::string& warning : source.warnings)
        remark(warning, palette::warning);
}

} // namespace

void tableChooser(ExplorerState& state)
{
    const Surface& surface = state.scene.surface;
    const std::string name = std::filesystem::path(surface.tableFile).filename().string();
    const std::string label =
        elided(name.empty() ? "choose\u2026" : name, ImGui::GetContentRegionAvail().x - points(18)) + "##choose table";
    if (ImGui::Button(label.c_str(), {-1, 0}))
        state.requests.push_back({Request::Kind::OpenDialog, {}});
    tooltip(surface.tableFile + (surface.tableFile.empty() ? "" : "\n") +
            "Choose a measurement (CSV, MERL, RGL, Cornell, Zemax, CUReT, OpenMATERIAL); or drop one on the window.");
}

void tableRows(ExplorerState& state)
{
    const Surface& surface = state.scene.surface;
    rowLabel("", "Measurement");
    tableChooser(state);
    if (surface.table)
        drawFacts(surface.table->table);
    else
        remark("No measurement is loaded, so the surface is black.", palette::warning);
}

} // namespace reflectance::explorer
