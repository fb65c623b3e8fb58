#include "app/explorer/ui/history_buttons.h"

#include "app/explorer/ui/tool_button.h"
#include "app/explorer/ui/widgets.h"

#include <cmath>

namespace reflectance::explorer {

namespace {

using Kind = Request::Kind;

float arrowWidth()
{
    return points(20);
}

/// Newest on top, as it will be looked for.
void drawSteps(ExplorerState& state)
{
    const History& history = state.history;
    remark("History: a click goes there");
    for (std::size_t back = 0; back < history.steps().size(); ++back) {
        const std::size_t step = history.steps().size() - 1 - back;
        const bool isHere = step == history.here();
        const ImU32 color = step > history.here() ? palette::quiet : palette::text;
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        const std::string label = history.steps()[step].name + "##" + std::to_string(step);
        if (ImGui::Selectable(label.c_str(), isHere))
            state.requests.push_back({Kind::GoToStep, std::to_string(step)});
        ImGui::PopStyleColor();
        tooltip(isHere                  ? "What is on screen."
                : step > history.here() ? "Redo up to here."
                                        : "Undo what came after this.");
        if (isHere && ImGui::IsWindowAppearing())
            ImGui::SetScrollHereY();
    }
}

void drawListButton(ExplorerState& state)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 size{arrowWidth(), toolButtonHeight()};
    if (ImGui::InvisibleButton("history", size))
        ImGui::OpenPopup("history list");
    const bool hovered = ImGui::IsItemHovered();
    tooltip("The history: every step since the program began, at most 200. A click goes back or forth to it.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered || ImGui::IsPopupOpen("history list"))
        list.AddRectFilled(start, {start.x + size.x, start.y + size.y}, ImGui::GetColorU32(palette::raised), points(6));
    const ImVec2 middle{start.x + size.x / 2, start.y + size.y / 2};
    const float r = points(4);
    list.AddTriangleFilled({middle.x - r, middle.y - r / 2}, {middle.x + r, middle.y - r / 2},
                           {middle.x, middle.y + r / 2}, ImGui::GetColorU32(palette::accent));
    ImGui::SetNextWindowPos({start.x, start.y + size.y + points(4)});
    ImGui::SetNextWindowSizeConstraints({points(210), 0}, {points(360), points(420)});
    if (ImGui::BeginPopup("history list")) {
        drawSteps(state);
        ImGui::EndPopup();
    }
    ImGui::SameLine(0, points(6));
}

} // namespace

float historyButtonsWidth()
{
    return 2 * (toolButtonWidth("Undo", false) + points(2)) + arrowWidth() + points(6);
}

void drawHistoryButtons(ExplorerState& state)
{
    const History& history = state.history;
    const std::string undo =
        history.canUndo() ? "Undo: " + history.undoName() + ".  Ctrl+Z" : "Nothing to undo.  Ctrl+Z";
    if (drawToolButton({Icon::Undo, "Undo", false, false, history.canUndo()}, undo.c_str()))
        state.requests.push_back({Kind::Undo, {}});
    const std::string redo =
        history.canRedo() ? "Redo: " + history.redoName() + ".  Ctrl+Shift+Z" : "Nothing to redo.  Ctrl+Shift+Z";
    if (drawToolButton({Icon::Redo, "Redo", false, false, history.canRedo()}, redo.c_str()))
        state.requests.push_back({Kind::Redo, {}});
    drawListButton(state);
}

} // namespace reflectance::explorer
