#include "app/explorer/ui/ui.h"
#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/page.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

/// How tabs look where there is so much room for them.
struct TabStyle {
    Face face = Face::Body;
    float padding = 0.0F; ///< left and right of the name together
    float longest = 1e9F; ///< of a name; longer ones end in an ellipsis
};

/// Generous where there is room; else with less around the names, then smaller, then shortened.
TabStyle styleFor(float room)
{
    const auto pages = workbenchPages();
    const auto count = static_cast<float>(pages.size());
    for (const Face which : {Face::Body, Face::Small}) {
        float names = 0.0F;
        for (const WorkbenchPage& page : pages)
            names += sizeIn(which, page.name).x;
        if (const float padding = (room - names) / count; padding >= points(8))
            return {which, std::min(padding, points(26))};
    }
    return {Face::Small, points(6), room / count - points(6)};
}

/// A tab: quiet text, an accent line above the open one.
bool tab(const WorkbenchPage& page, bool open, const TabStyle& style)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImGui::PushFont(face(style.face));
    const std::string name = elided(page.name, style.longest);
    ImGui::PopFont();
    const ImVec2 text = sizeIn(style.face, name);
    const ImVec2 size{text.x + style.padding, workbenchTabsHeight()};
    const bool pressed = ImGui::InvisibleButton(page.id, size);
    const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    tooltip(page.about);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (open || hovered)
        list.AddRectFilled(start, {start.x + size.x, start.y + size.y},
                           ImGui::GetColorU32(open ? palette::card : palette::raised));
    if (open)
        list.AddRectFilled(start, {start.x + size.x, start.y + points(2)}, ImGui::GetColorU32(palette::accent));
    drawText(list, style.face, {start.x + style.padding / 2, start.y + (size.y - text.y) / 2},
             open || hovered ? palette::text : palette::quiet, name);
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
    const TabStyle style = styleFor(ImGui::GetContentRegionAvail().x);
    for (const WorkbenchPage& page : workbenchPages())
        if (tab(page, &page == open, style))
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
