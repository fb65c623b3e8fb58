#include "app/explorer/ui/folder.h"
#include "app/explorer/ui/ui.h"
#include "app/explorer/ui/widgets.h"

#include <algorithm>
#include <imgui_stdlib.h>

namespace reflectance::explorer {

namespace fs = std::filesystem;

namespace {

constexpr const char* title = "Open a mesh, a scene or an environment";

void goTo(BrowserMemory& memory, const fs::path& folder)
{
    memory.folder = folder.has_filename() || !folder.has_parent_path() ? folder : folder.parent_path();
    if (memory.folder.empty())
        memory.folder = "/";
    memory.typed.clear();
    memory.selected = 0;
    memory.wantsFocus = true;
    memory.listing.reset();
}

const Listing& listingOf(BrowserMemory& memory, const fs::path& folder)
{
    if (memory.listing && memory.listing->folder == folder && memory.listing->everyFile == memory.everyFile)
        return *memory.listing;
    Listing listing{folder, memory.everyFile, {}, {}};
    auto entries = listFolder(folder, memory.everyFile);
    if (entries)
        listing.entries = *std::move(entries);
    else
        listing.problem = entries.error().sentence();
    return memory.listing.emplace(std::move(listing));
}

void choose(ExplorerState& state, const fs::path& file)
{
    state.requests.push_back({Request::Kind::OpenFile, file.string()});
    state.showFileBrowser = false;
}

void activate(ExplorerState& state, const fs::path& folder, const FolderEntry& entry)
{
    if (entry.isFolder)
        goTo(state.panels.browser, folder / entry.name);
    else
        choose(state, folder / entry.name);
}

/// Tab completes, the arrows move the selection while the path line keeps the keyboard.
int onPathKey(ImGuiInputTextCallbackData* data)
{
    BrowserMemory& memory = *static_cast<BrowserMemory*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory) {
        memory.selected += data->EventKey == ImGuiKey_UpArrow ? -1 : 1;
    } else if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion && memory.listing) {
        const std::string text =
            completed({data->Buf, static_cast<std::size_t>(data->BufTextLen)}, memory.listing->entries);
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, text.c_str());
        memory.selected = 0;
    } else if (data->EventFlag == ImGuiInputTextFlags_CallbackEdit) {
        memory.selected = 0;
    }
    return 0;
}

/// True when Enter was pressed in it.
bool drawPathLine(BrowserMemory& memory)
{
    constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory |
                                          ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_CallbackEdit;
    if (memory.wantsFocus)
        ImGui::SetKeyboardFocusHere();
    memory.wantsFocus = false;
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputTextWithHint("##path", "type to filter, or a path", &memory.typed, flags, onPathKey, &memory);
    tooltip("Filters the list; a path with / leads to another folder, ~ is home. Tab completes, the arrow keys select, "
            "Enter opens.");
    return entered;
}

void drawFolderLine(BrowserMemory& memory, const fs::path& folder)
{
    if (ImGui::Button("\u2191 Up"))
        goTo(memory, folder.parent_path());
    tooltip("To the folder above.");
    ImGui::SameLine();
    if (ImGui::Button("Home"))
        goTo(memory, homeFolder());
    tooltip(homeFolder().string());
    ImGui::SameLine();
    const float filterWidth = ImGui::GetFrameHeight() + sizeIn(Face::Body, "every file").x + points(14);
    const float pathWidth = ImGui::GetContentRegionAvail().x - filterWidth;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(elided(folder.string(), pathWidth).c_str());
    tooltip(folder.string());
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - filterWidth + points(8));
    ImGui::Checkbox("every file", &memory.everyFile);
    tooltip("Also show files with other endings than .obj .ply .off .stl .json .png .exr .hdr.");
}

/// One line of the table; returns true when it is to be opened.
bool drawEntry(const FolderEntry& entry, bool selected, bool scrollTo)
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = entry.name + (entry.isFolder ? "/" : "");
    if (selected && scrollTo)
        ImGui::SetScrollHereY();
    const bool opened = ImGui::Selectable(label.c_str(), selected, ImGuiSelectableFlags_SpanAllColumns);
    tooltip(entry.isFolder ? "Open this folder: " + entry.name : "Open " + entry.name);
    ImGui::TableNextColumn();
    const std::string_view kind = kindOfFile(entry.name);
    remark(entry.isFolder ? "folder" : kind, palette::quiet);
    ImGui::TableNextColumn();
    if (!entry.isFolder)
        remark(readableSize(entry.size), palette::quiet);
    return opened;
}

/// The entry that was clicked, or -1.
int drawEntries(const std::vector<FolderEntry>& entries, int selected, bool scrollTo)
{
    int clicked = -1;
    if (!ImGui::BeginTable("entries", 3, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg))
        return clicked;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("kind", ImGuiTableColumnFlags_WidthFixed, points(84));
    ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, points(64));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(entries.size()));
    if (scrollTo)
        clipper.ForceDisplayRangeByIndices(selected, selected + 1);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            if (drawEntry(entries[static_cast<std::size_t>(i)], i == selected, scrollTo))
                clicked = i;
    ImGui::EndTable();
    return clicked;
}

void drawRecent(ExplorerState& state)
{
    remark("Recent files", palette::quiet);
    if (state.preferences.recentFiles.empty())
        remark("none yet");
    for (const std::string& path : state.preferences.recentFiles) {
        const std::string name = elided(fs::path(path).filename().string(), ImGui::GetContentRegionAvail().x);
        if (ImGui::Selectable((name + "##" + path).c_str()))
            choose(state, path);
        tooltip(path);
    }
}

/// Enter: what is selected; without a match, the typed path as it stands, so that its error is said.
void openSelected(ExplorerState& state, const TypedPlace& place, const std::vector<FolderEntry>& shown)
{
    BrowserMemory& memory = state.panels.browser;
    if (!shown.empty())
        activate(state, place.folder, shown[static_cast<std::size_t>(memory.selected)]);
    else if (!place.leaf.empty())
        choose(state, place.folder / place.leaf);
}

void drawFooter(ExplorerState& state, const TypedPlace& place, const std::vector<FolderEntry>& shown)
{
    const float width = points(96);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2 * width - points(8));
    if (ImGui::Button("Cancel", {width, 0}))
        state.showFileBrowser = false;
    tooltip("Close without opening anything.  Esc");
    ImGui::SameLine(0, points(8));
    ImGui::BeginDisabled(shown.empty() && place.leaf.empty());
    if (toggleButton("Open", true, {width, 0}))
        openSelected(state, place, shown);
    tooltip("Open what is selected.  Enter");
    ImGui::EndDisabled();
}

void drawContents(ExplorerState& state)
{
    BrowserMemory& memory = state.panels.browser;
    const int selectedBefore = memory.selected;
    const bool entered = drawPathLine(memory);
    const TypedPlace place = placeOf(memory.folder, memory.typed);
    drawFolderLine(memory, place.folder);
    // A copy: opening a folder below replaces the listing.
    const Listing listing = listingOf(memory, place.folder);
    const std::vector<FolderEntry> shown = matching(listing.entries, place.leaf);
    memory.selected = std::clamp(memory.selected, 0, std::max(0, static_cast<int>(shown.size()) - 1));

    const float listHeight = -ImGui::GetFrameHeightWithSpacing() - points(4);
    ImGui::BeginChild("recent", {points(180), listHeight});
    drawRecent(state);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::well);
    ImGui::BeginChild("folder", {0, listHeight}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleColor();
    if (!listing.problem.empty())
        remark(listing.problem, palette::error, Face::Body);
    else if (shown.empty())
        remark(listing.entries.empty() ? "No folder, mesh, scene or environment here." : "Nothing here matches.",
               palette::quiet, Face::Body);
    const int clicked = drawEntries(shown, memory.selected, memory.selected != selectedBefore);
    ImGui::EndChild();
    if (clicked >= 0)
        activate(state, place.folder, shown[static_cast<std::size_t>(clicked)]);
    else if (entered)
        openSelected(state, place, shown);
    drawFooter(state, place, shown);
}

} // namespace

void drawFileBrowser(ExplorerState& state)
{
    BrowserMemory& memory = state.panels.browser;
    if (state.showFileBrowser && !ImGui::IsPopupOpen(title)) {
        std::error_code none;
        goTo(memory, memory.folder.empty() ? fs::current_path(none) : memory.folder);
        ImGui::OpenPopup(title);
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(
        {std::min(points(760), display.x - points(24)), std::min(points(540), display.y - points(24))});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::BeginPopupModal(title, &state.showFileBrowser, flags))
        return;
    drawContents(state);
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
        state.showFileBrowser = false;
    ImGui::EndPopup();
}

} // namespace reflectance::explorer
