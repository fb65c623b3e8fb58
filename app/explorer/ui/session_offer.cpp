#include "app/explorer/ui/session_offer.h"

#include "app/explorer/ui/toast.h"
#include "app/explorer/ui/widgets.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

std::string described(const EarlierSession& session)
{
    return session.content.empty() ? "changed " + session.when : session.content + ", changed " + session.when;
}

/// A button, and beside it the key that does the same. Returns whether it was pressed.
bool button(const char* label, const char* key, const char* about)
{
    const bool pressed = ImGui::Button(label);
    tooltip(about);
    ImGui::SameLine(0, points(6));
    ImGui::AlignTextToFramePadding();
    remark(key);
    return pressed;
}

} // namespace

float drawSessionOffer(ExplorerState& state, ImVec2 bottomLeft)
{
    const EarlierSession* offered = offeredSession(state);
    if (!offered)
        return bottomLeft.y;
    using Kind = Request::Kind;
    const std::string title = "The last session was cut off.", content = described(*offered);
    beginToast("session offer", bottomLeft,
               points(20) + std::max({points(206), sizeIn(Face::Strong, title).x, sizeIn(Face::Small, content).x}));
    remark(title, palette::text, Face::Strong);
    remark(content);
    ImGui::Dummy({0, points(2)});
    ImGui::PushStyleColor(ImGuiCol_Button, palette::chosen);
    if (button("Restore", "Ctrl+R", "Bring it back. What is on screen now goes to the Open menu, if it was changed."))
        state.requests.push_back({Kind::OpenFile, offered->file});
    ImGui::PopStyleColor();
    ImGui::SameLine(0, points(20));
    if (button("Dismiss", "Esc", "Leave it. The Open menu has it until the program is closed."))
        state.requests.push_back({Kind::Dismiss, offered->file});
    return endToast(palette::accent);
}

} // namespace reflectance::explorer
