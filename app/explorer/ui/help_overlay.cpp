#include "app/explorer/ui/shortcuts.h"
#include "app/explorer/ui/ui.h"
#include "app/explorer/ui/widgets.h"

#include <algorithm>
#include <string_view>

namespace reflectance::explorer {

namespace {

void drawGroupHeading(const char* group)
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::Dummy({0, points(2)});
    remark(group, palette::accent, Face::Strong);
}

void drawShortcut(const Shortcut& shortcut)
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(shortcut.gesture);
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0.0F);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::quiet);
    ImGui::TextUnformatted(shortcut.effect);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
}

void drawTable()
{
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {points(6), points(2)});
    if (ImGui::BeginTable("shortcuts", 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("gesture", 0, 0.42F);
        ImGui::TableSetupColumn("effect", 0, 0.58F);
        std::string_view group;
        for (const Shortcut& shortcut : shortcuts()) {
            if (group != shortcut.group)
                drawGroupHeading(shortcut.group);
            group = shortcut.group;
            drawShortcut(shortcut);
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

} // namespace

void drawHelp(ExplorerState& state)
{
    if (!state.showHelp)
        return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 size{std::min(points(600), display.x - points(24)), std::min(points(640), display.y - points(24))};
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {points(20), points(16)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::floating);
    ImGui::Begin("Gestures and keys", &state.showHelp,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings);
    drawTable();
    ImGui::Dummy({0, points(4)});
    remark(std::string("Vectors: N normal, L to the light, V to the viewer, R = L mirrored about N. Typeface: Inter, "
                       "SIL Open Font "
                       "License. ") +
           state.firstPicture);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

} // namespace reflectance::explorer
