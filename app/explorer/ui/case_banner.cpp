#include "app/explorer/ui/case_banner.h"

#include "app/explorer/ui/widgets.h"

#include <algorithm>

namespace reflectance::explorer {

void drawCaseBanner(ExplorerState& state, ImVec2 topLeft, ImVec2 room)
{
    if (!state.putAside || state.guide.number > 0)
        return;
    const ImVec2 padding{points(12), points(9)};
    const bool low = room.y < points(320);
    const float wide = std::min(room.x, points(440));
    const std::string& caption = state.putAside->caption;
    const ImFont& small = *face(Face::Small);
    const float text = small
                           .CalcTextSizeA(small.FontSize, FLT_MAX, wide - 2 * padding.x, caption.data(),
                                          caption.data() + caption.size())
                           .y;
    const float full = 2 * padding.y + face(Face::Strong)->FontSize + text + ImGui::GetFrameHeight() +
                       2 * ImGui::GetStyle().ItemSpacing.y + points(2);
    const float height = low ? ImGui::GetFrameHeight() + points(8) : full;
    ImGui::SetCursorScreenPos(topLeft);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::floating);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, low ? ImVec2(padding.x, points(4)) : padding);
    ImGui::BeginChild("##case", {wide, height}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                          ImGuiWindowFlags_AlwaysUseWindowPadding);
    if (low) {
        ImGui::AlignTextToFramePadding();
        remark(elided(state.putAside->title, wide - points(210)), palette::text, Face::Body);
        tooltip(caption);
        ImGui::SameLine();
    } else {
        remark(state.putAside->title, palette::text, Face::Strong);
        remark(caption);
    }
    if (ImGui::Button("Back to your scene"))
        state.requests.push_back({Request::Kind::LeaveCase, {}});
    tooltip("Your scene waits as you left it; nothing you do to this case touches it.  Esc");
    ImGui::SameLine(0, points(6));
    ImGui::AlignTextToFramePadding();
    remark("Esc");
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

} // namespace reflectance::explorer
