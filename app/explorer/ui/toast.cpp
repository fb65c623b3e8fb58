#include "app/explorer/ui/toast.h"

#include "app/explorer/ui/widgets.h"

namespace reflectance::explorer {

namespace {

constexpr ImGuiWindowFlags toastFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

} // namespace

void beginToast(const char* id, ImVec2 bottomLeft, float width)
{
    const float margin = points(12);
    ImGui::SetNextWindowPos({bottomLeft.x + margin, bottomLeft.y - margin}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowContentSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::floating);
    ImGui::Begin(id, nullptr, toastFlags);
    ImGui::Indent(points(4));
}

float endToast(ImU32 mark)
{
    ImGui::Unindent(points(4));
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    ImGui::PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, false);
    ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + points(5), corner.y + size.y}, mark, points(8),
                                              ImDrawFlags_RoundCornersLeft);
    ImGui::PopClipRect();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return corner.y;
}

} // namespace reflectance::explorer
