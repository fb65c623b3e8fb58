#include "app/explorer/ui/probe_card.h"

#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/piece.h"
#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/page.h"
#include "app/explorer/viewed_scene.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace reflectance::explorer {
namespace {

std::string valuesOf(const Probe& probe)
{
    std::string text =
        written(probe.value.x, 3) + "  " + written(probe.value.y, 3) + "  " + written(probe.value.z, 3) + "  \u2192";
    for (const std::uint8_t code : probe.codes)
        text += " " + std::to_string(code);
    return text;
}

bool pageIsOpen(const ExplorerState& state)
{
    const WorkbenchPage* page = openPage(state);
    return page != nullptr && std::string_view(page->id) == "probe";
}

} // namespace

void drawProbeCard(ExplorerState& state, ImVec2 low, ImVec2 high)
{
    const FoundProbe* found = state.probe.found();
    if (!found || pageIsOpen(state))
        return;
    std::vector<std::string> lines;
    if (found->b)
        lines = {"A  " + valuesOf(found->a), "B  " + valuesOf(*found->b)};
    else
        lines = {valuesOf(found->a)};
    ImVec2 size{points(150), ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y + 2 * piecePadding().y};
    for (const std::string& line : lines) {
        size.x = std::max(size.x, sizeIn(Face::Small, line).x + 2 * piecePadding().x + points(2));
        size.y += sizeIn(Face::Small, line).y + ImGui::GetStyle().ItemSpacing.y;
    }
    // At the lower edge, where neither arrows nor lobe are hidden by it; above the names of A and B.
    const float below = state.compare.on ? ImGui::GetFrameHeight() + points(16) : points(10);
    const ImVec2 corner{std::max(low.x + points(8), std::round((low.x + high.x - size.x) / 2)),
                        std::max(low.y + points(8), high.y - below - size.y)};
    beginPiece("##probe card", corner, size);
    for (const std::string& line : lines) {
        remark(line, palette::text);
        tooltip(
            "Linear red, green and blue at this point, in double, and the code values that the sensor makes of them.");
    }
    if (ImGui::Button("Formula"))
        state.preferences.workbenchPage = "probe";
    tooltip("The formula with these numbers filled in, stage by stage.  P");
    ImGui::SameLine(0, points(4));
    if (state.probe.picked) {
        if (ImGui::Button("Remove"))
            state.probe.remove(state.scene);
        tooltip("Take this pin off the object.");
    } else {
        if (ImGui::Button("Pin"))
            state.probe.pin(state.scene);
        tooltip("Keep this probe on the object while others are made.");
    }
    ImGui::EndChild();
}

void drawTermBanner(ExplorerState& state, ImVec2 topLeft, float room)
{
    if (!seesTermAlone(state))
        return;
    const std::string button = "Show all";
    const float buttonWidth = sizeIn(Face::Body, button).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float most = room - 2 * piecePadding().x - buttonWidth - points(8);
    ImGui::PushFont(face(Face::Body));
    const std::string text = elided("Only: " + wordsFor(state.probe.term), most);
    ImGui::PopFont();
    const ImVec2 size{sizeIn(Face::Body, text).x + buttonWidth + points(10) + 2 * piecePadding().x,
                      ImGui::GetFrameHeight() + 2 * piecePadding().y};
    beginPiece("##term", topLeft, size);
    ImGui::AlignTextToFramePadding();
    remark(text, palette::warning, Face::Body);
    tooltip("A part of the picture is seen alone; the scene is as it was. What is below 0 shows black.");
    ImGui::SameLine(0, points(8));
    if (ImGui::Button(button.c_str()))
        state.probe.term.clear();
    tooltip("The whole picture again.  Esc");
    ImGui::EndChild();
}

} // namespace reflectance::explorer
