#include "app/explorer/ui/tool_button.h"

#include "app/explorer/ui/widgets.h"

namespace reflectance::explorer {

float toolButtonHeight()
{
    return points(32);
}

float toolButtonWidth(const char* label, bool withLabel)
{
    return withLabel ? points(38) + sizeIn(Face::Body, label).x : points(36);
}

bool drawToolButton(const ToolButton& button, const char* about)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 size{toolButtonWidth(button.label, button.withLabel), toolButtonHeight()};
    ImGui::BeginDisabled(!button.enabled);
    const bool pressed = ImGui::InvisibleButton(button.label, size);
    ImGui::EndDisabled();
    const bool hovered = button.enabled && ImGui::IsItemHovered();
    tooltip(about);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (button.on || hovered)
        list.AddRectFilled(start, {start.x + size.x, start.y + size.y},
                           ImGui::GetColorU32(button.on ? palette::chosen : palette::raised), points(6));
    const float middle = start.y + size.y / 2;
    const float iconX = button.withLabel ? start.x + points(18) : start.x + size.x / 2;
    const ImU32 color = !button.enabled ? palette::faint : button.on ? palette::text : palette::accent;
    drawIcon(list, button.icon, {iconX, middle}, points(7.5F), ImGui::GetColorU32(color));
    if (button.withLabel)
        drawText(list, Face::Body, {start.x + points(31), middle - sizeIn(Face::Body, button.label).y / 2},
                 button.enabled ? palette::text : palette::faint, button.label);
    ImGui::SameLine(0, points(2));
    return pressed && button.enabled;
}

} // namespace reflectance::explorer
