#include "app/explorer/ui/piece.h"

#include "app/explorer/ui/widgets.h"

namespace reflectance::explorer {

ImVec2 piecePadding()
{
    return {points(8), points(6)};
}

void beginPiece(const char* id, ImVec2 corner, ImVec2 size)
{
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::floating);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, piecePadding());
    ImGui::BeginChild(id, size, false, stillWindow | ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

} // namespace reflectance::explorer
