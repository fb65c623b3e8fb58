#include "app/explorer/ui/rung_row.h"

#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/scene/rung_list.h"

#include <algorithm>
#include <imgui.h>

namespace reflectance::explorer {
namespace {

std::string about(const RungFacts& rung)
{
    std::string text = std::string("Gives up ") + rung.about + ".";
    if (rung.onCpu != rung.onGl)
        text += rung.onGl ? " GL draws it." : " The CPU draws it, on a thread: the picture follows a little later.";
    return text;
}

std::string menuTooltip(const ExplorerState& state, const Surface& surface)
{
    std::string text =
        "How this surface's picture is made: an arithmetic and what is given up, kept with the variant. Compare A in "
        "double with B in glsl, and the difference is the error of the precision. The badge, the lens and "
        "the prices speak of the picture without rungs.";
    const bool isB = state.compare.on && state.compare.handOnB;
    for (const SkippedRung& rung : isB ? state.idleRungsB : state.idleRungsA)
        if (std::find(surface.rungs.begin(), surface.rungs.end(), rung.rung) != surface.rungs.end())
            text += "\n" + rung.rung + " changes nothing here: " + rung.why + ".";
    return text;
}

/// A line of the menu; true where it was pressed.
bool rungLine(const RungFacts& rung, bool taken)
{
    const bool pressed = ImGui::Selectable(rung.id, taken);
    tooltip(about(rung));
    if (taken)
        ImGui::SetItemDefaultFocus();
    return pressed;
}

void drawMenu(Surface& surface)
{
    if (ImGui::Selectable("as the window draws", surface.rungs.empty()))
        surface.rungs.clear();
    tooltip("No rung: GL draws the picture, and nothing is given up.");
    std::optional<RungAxis> axis;
    for (const RungFacts& rung : rungList) {
        if (axis != rung.axis)
            remark(nameOf(rung.axis), palette::accent);
        axis = rung.axis;
        const bool taken = std::find(surface.rungs.begin(), surface.rungs.end(), rung.id) != surface.rungs.end();
        if (rungLine(rung, taken))
            surface.rungs = toggledRung(surface.rungs, rung);
    }
}

} // namespace

std::string rungsText(const Surface& surface)
{
    return joined(surface.rungs, " + ");
}

void rungRow(ExplorerState& state)
{
    Surface& surface = surfaceInHand(state.compare, state.scene);
    rowLabel("", "Rungs");
    const std::string shown = surface.rungs.empty() ? "as the window draws" : rungsText(surface);
    if (beginMenu("##rungs", shown.c_str())) {
        drawMenu(surface);
        ImGui::EndCombo();
    } else {
        tooltip(menuTooltip(state, surface));
    }
}

} // namespace reflectance::explorer
