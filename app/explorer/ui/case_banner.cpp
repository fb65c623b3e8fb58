#include "app/explorer/ui/case_banner.h"

#include "app/explorer/ui/widgets.h"

#include <algorithm>

namespace reflectance::explorer {

void drawCaseBanner(ExplorerState& state, ImVec2 topLeft, float width)
{
    if (!state.putAside)
        return;
    const ImVec2 padding{points(12), points(9)};
    const float wide = std::min(width, points(440));
    const std::string& caption = state.putAside->caption;
    const ImFont& small = *face(Face::Small);
    const float text = small
                           .CalcTextSizeA(small.FontSize, FLT_MAX, wide - 2 * padding.x, caption.data(),
                                          caption.data() + caption.size())
                           .y;
    const float height = 2 * padding.y + face(Face::Strong)->FontSize + text + ImGui::GetFrameHeight() +
                         2 * ImGui::GetStyle().ItemSpacing.y + points(2);
    ImGui::SetCursorScreenPos(topLeft);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::floating);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::BeginChild("##case", {wide, height}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                          ImGuiWindowFlags_AlwaysUseWindowPadding);
    remark(state.putAside->title, palette::text, Face::Strong);
    remark(caption);
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
