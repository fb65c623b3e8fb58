#include "app/explorer/ui/message_toast.h"

#include "app/explorer/ui/widgets.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

constexpr ImGuiWindowFlags toastFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

} // namespace

void drawMessage(ExplorerState& state, ImVec2 bottomLeft, float width)
{
    if (!state.message)
        return;
    const float margin = points(12);
    const float wrap = std::min(width - 4 * margin, points(640));
    ImGui::SetNextWindowPos({bottomLeft.x + margin, bottomLeft.y - margin}, ImGuiCond_Always, {0, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::floating);
    ImGui::Begin("message", nullptr, toastFlags);
    const ImU32 mark = state.message->isError ? palette::error : palette::accent;
    const ImVec2 corner = ImGui::GetWindowPos();
    const float top = ImGui::GetCursorPosY();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap - points(40));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + points(4));
    ImGui::TextUnformatted(state.message->text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SameLine(0, points(16));
    ImGui::SetCursorPosY(top - points(1));
    const bool dismissed = ImGui::SmallButton("\u00D7##dismiss");
    tooltip("Dismiss this message.  Esc");
    const ImVec2 size = ImGui::GetWindowSize();
    ImGui::PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, false);
    ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + points(5), corner.y + size.y}, mark, points(8),
                                              ImDrawFlags_RoundCornersLeft);
    ImGui::PopClipRect();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    if (dismissed)
        state.message.reset();
}

} // namespace reflectance::explorer
