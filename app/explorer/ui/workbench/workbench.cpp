#include "app/explorer/ui/ui.h"
#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/page.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

/// A tab: quiet text, an accent line above the open one.
bool tab(const WorkbenchPage& page, bool open)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 size{sizeIn(Face::Body, page.name).x + points(26), workbenchTabsHeight()};
    const bool pressed = ImGui::InvisibleButton(page.id, size);
    const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    tooltip(page.about);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (open || hovered)
        list.AddRectFilled(start, {start.x + size.x, start.y + size.y},
                           ImGui::GetColorU32(open ? palette::card : palette::raised));
    if (open)
        list.AddRectFilled(start, {start.x + size.x, start.y + points(2)}, ImGui::GetColorU32(palette::accent));
    drawText(list, Face::Body, {start.x + points(13), start.y + (size.y - sizeIn(Face::Body, page.name).y) / 2},
             open || hovered ? palette::text : palette::quiet, page.name);
    ImGui::SameLine(0, 0);
    return pressed;
}

} // namespace

const WorkbenchPage* openPage(const ExplorerState& state)
{
    const auto pages = workbenchPages();
    const auto found = std::find_if(pages.begin(), pages.end(), [&](const WorkbenchPage& page) {
        return state.preferences.workbenchPage == page.id;
    });
    return found == pages.end() ? nullptr : &*found;
}

void togglePage(ExplorerState& state, const char* id)
{
    std::string& open = state.preferences.workbenchPage;
    open = open == id ? std::string() : std::string(id);
}

void togglePage(ExplorerState& state, int index)
{
    const auto pages = workbenchPages();
    if (index >= 0 && index < static_cast<int>(pages.size()))
        togglePage(state, pages[static_cast<std::size_t>(index)].id);
}

bool workbenchIsOpen(const ExplorerState& state)
{
    return openPage(state) != nullptr;
}

float workbenchTabsHeight()
{
    return workbenchPages().empty() ? 0.0F : points(28);
}

void drawWorkbenchTabs(ExplorerState& state)
{
    const WorkbenchPage* open = openPage(state);
    for (const WorkbenchPage& page : workbenchPages())
        if (tab(page, &page == open))
            togglePage(state, page.id);
    ImGui::NewLine();
}

void drawWorkbench(ExplorerState& state)
{
    if (const WorkbenchPage* page = openPage(state)) {
        ImGui::PushID(page->id);
        page->draw(state);
        ImGui::PopID();
    }
}

} // namespace reflectance::explorer
