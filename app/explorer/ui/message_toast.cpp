#include "app/explorer/ui/message_toast.h"

#include "app/explorer/ui/toast.h"
#include "app/explorer/ui/widgets.h"

#include <algorithm>

namespace reflectance::explorer {

void drawMessage(ExplorerState& state, ImVec2 bottomLeft, float width)
{
    if (!state.message || state.takingPicture) // it would stand in the picture
        return;
    const float wrap = std::min(width - points(48), points(640));
    const ImU32 mark = state.message->isError ? palette::error : palette::accent;
    beginToast("message", bottomLeft);
    const float top = ImGui::GetCursorPosY();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap - points(44));
    ImGui::TextUnformatted(state.message->text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SameLine(0, points(16));
    ImGui::SetCursorPosY(top - points(1));
    const bool dismissed = ImGui::SmallButton("\u00D7##dismiss");
    tooltip("Dismiss this message.  Esc");
    endToast(mark);
    if (dismissed)
        state.message.reset();
}

} // namespace reflectance::explorer
