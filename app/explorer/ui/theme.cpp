#include "app/explorer/ui/theme.h"

#include "app/explorer/ui/ui.h"

namespace reflectance::explorer {

namespace {

ImVec4 vector(ImU32 color)
{
    return ImGui::ColorConvertU32ToFloat4(color);
}

ImVec4 faded(ImU32 color, float alpha)
{
    ImVec4 c = vector(color);
    c.w = alpha;
    return c;
}

void setShape(ImGuiStyle& style)
{
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.CellPadding = {6, 4};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 6;
    style.WindowRounding = 8;
    style.ChildRounding = 8;
    style.PopupRounding = 6;
    style.FrameRounding = 5;
    style.GrabRounding = 3;
    style.ScrollbarRounding = 6;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowTitleAlign = {0.5F, 0.5F};
    style.DisabledAlpha = 0.45F;
    style.CircleTessellationMaxError = 0.15F;
}

void setGrounds(ImVec4* colors)
{
    colors[ImGuiCol_WindowBg] = vector(palette::ground);
    colors[ImGuiCol_ChildBg] = faded(palette::ground, 0.0F);
    colors[ImGuiCol_PopupBg] = vector(palette::floating);
    colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45F);
    colors[ImGuiCol_NavWindowingDimBg] = ImVec4(0, 0, 0, 0.45F);
    colors[ImGuiCol_MenuBarBg] = vector(palette::ground);
    colors[ImGuiCol_TitleBg] = vector(palette::card);
    colors[ImGuiCol_TitleBgActive] = vector(palette::card);
    colors[ImGuiCol_TitleBgCollapsed] = vector(palette::card);
    colors[ImGuiCol_Border] = vector(palette::line);
    colors[ImGuiCol_Separator] = vector(palette::line);
    colors[ImGuiCol_TableBorderLight] = vector(palette::line);
    colors[ImGuiCol_TableBorderStrong] = vector(palette::line);
    colors[ImGuiCol_TableHeaderBg] = vector(palette::raised);
    colors[ImGuiCol_TableRowBgAlt] = ImVec4(1, 1, 1, 0.025F);
    colors[ImGuiCol_ScrollbarBg] = faded(palette::ground, 0.0F);
    colors[ImGuiCol_ScrollbarGrab] = vector(palette::raised);
    colors[ImGuiCol_ScrollbarGrabHovered] = vector(palette::hovered);
    colors[ImGuiCol_ScrollbarGrabActive] = vector(palette::quiet);
}

void setControls(ImVec4* colors)
{
    colors[ImGuiCol_Text] = vector(palette::text);
    colors[ImGuiCol_TextDisabled] = vector(palette::quiet);
    colors[ImGuiCol_TextSelectedBg] = faded(palette::accent, 0.35F);
    colors[ImGuiCol_FrameBg] = vector(palette::well);
    colors[ImGuiCol_FrameBgHovered] = vector(IM_COL32(30, 30, 30, 255));
    colors[ImGuiCol_FrameBgActive] = vector(IM_COL32(30, 30, 30, 255));
    colors[ImGuiCol_Button] = vector(palette::raised);
    colors[ImGuiCol_ButtonHovered] = vector(palette::hovered);
    colors[ImGuiCol_ButtonActive] = vector(palette::chosen);
    colors[ImGuiCol_Header] = faded(palette::accent, 0.24F);
    colors[ImGuiCol_HeaderHovered] = ImVec4(1, 1, 1, 0.08F);
    colors[ImGuiCol_HeaderActive] = faded(palette::accent, 0.32F);
    colors[ImGuiCol_CheckMark] = vector(palette::accent);
    colors[ImGuiCol_SliderGrab] = vector(palette::accent);
    colors[ImGuiCol_SliderGrabActive] = vector(IM_COL32(160, 204, 246, 255));
    colors[ImGuiCol_SeparatorHovered] = vector(palette::accent);
    colors[ImGuiCol_SeparatorActive] = vector(palette::accent);
    colors[ImGuiCol_ResizeGrip] = vector(palette::raised);
    colors[ImGuiCol_ResizeGripHovered] = vector(palette::accent);
    colors[ImGuiCol_ResizeGripActive] = vector(palette::accent);
    colors[ImGuiCol_PlotHistogram] = vector(palette::accent);
    colors[ImGuiCol_DragDropTarget] = vector(palette::accent);
    colors[ImGuiCol_NavHighlight] = vector(palette::accent);
}

} // namespace

void applyTheme(float scale)
{
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    setShape(style);
    setGrounds(style.Colors);
    setControls(style.Colors);
    style.ScaleAllSizes(scale);
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
}

} // namespace reflectance::explorer
