#include "app/explorer/ui/workbench/surfaces_page.h"

#include "app/explorer/ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <imgui.h>

namespace reflectance::explorer {

namespace {

constexpr float pictureSide = 84.0F;
constexpr float tileWidth = 100.0F;
constexpr float tileHeight = 108.0F;

/// Dear ImGui writes into a buffer of fixed size; a search of more letters finds nothing anyway.
void searchField(std::string& search)
{
    std::array<char, 128> buffer{};
    search.copy(buffer.data(), buffer.size() - 1);
    ImGui::SetNextItemWidth(points(200));
    if (ImGui::InputTextWithHint("##search", "search names and sources", buffer.data(), buffer.size()))
        search = buffer.data();
    tooltip("Words that must occur in name, group, model, source or note.");
}

void groupMenu(std::string& chosen)
{
    const auto groups = surfaceGroups();
    const auto current =
        std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group->id == chosen; });
    const std::string shown = current == groups.end() ? "All groups" : (*current)->name;
    ImGui::SetNextItemWidth(points(250));
    if (!beginMenu("##group", shown.c_str())) {
        tooltip("Which groups are shown: one source, one model.");
        return;
    }
    if (ImGui::Selectable("All groups", chosen.empty()))
        chosen.clear();
    tooltip("Every surface of the library.");
    for (const auto& group : groups) {
        if (ImGui::Selectable(group->name.c_str(), group->id == chosen))
            chosen = group->id;
        tooltip(group->source);
    }
    ImGui::EndCombo();
}

void drawHead(ExplorerState& state, std::size_t count)
{
    SurfaceShelf& shelf = state.shelf;
    searchField(shelf.search);
    ImGui::SameLine();
    groupMenu(shelf.group);
    Surface& inHand = surfaceInHand(state.compare, state.scene);
    if (canGoBack(shelf, inHand)) {
        ImGui::SameLine();
        if (ImGui::Button("Back to before"))
            goBack(shelf, inHand);
        tooltip("The surface as it was before the first click on this page.");
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    remark(std::to_string(count) + (count == 1 ? " surface" : " surfaces"));
}

void surfaceTooltip(const LibrarySurface& surface, const ShelfPicture* picture)
{
    if (!tooltipIsDue())
        return;
    beginTooltip();
    ImGui::PushFont(face(Face::Strong));
    ImGui::TextUnformatted(surface.name.c_str());
    ImGui::PopFont();
    remark(surface.group->name + ", model " + surface.group->model, palette::accent);
    for (const auto& [name, numbers] : surface.values)
        ImGui::TextUnformatted((name + " = " + inBrief(numbers)).c_str());
    for (const SurfaceFact& fact : surface.facts)
        remark(fact.name + ": " + fact.text + "  (not rendered)");
    if (picture && !picture->budget.passive())
        remark("More light leaves than arrives: it " + properties::budgetText(picture->budget) +
                   ". The numbers stay as published.",
               palette::warning);
    else if (picture)
        remark("It " + properties::budgetText(picture->budget) + ".", palette::good);
    ImGui::TextUnformatted(surface.group->convention.c_str());
    remark(surface.group->note);
    remark(surface.group->source);
    endTooltip();
}

/// A mark in the corner of what returns more than arrives.
void drawWarning(ImDrawList& list, ImVec2 corner)
{
    const float r = points(7);
    const ImVec2 top{corner.x - r, corner.y + points(3)};
    list.AddTriangleFilled({top.x - r, top.y + 1.7F * r}, {top.x + r, top.y + 1.7F * r}, top,
                           ImGui::GetColorU32(palette::warning));
    drawText(list, Face::Small, {top.x - sizeIn(Face::Small, "!").x / 2, top.y + points(1)}, palette::ground, "!");
}

void drawPicture(ImDrawList& list, ImVec2 corner, const ShelfPicture* picture)
{
    const float side = points(pictureSide);
    const ImVec2 end{corner.x + side, corner.y + side};
    if (picture && picture->texture != 0)
        list.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture->texture)), corner, end,
                             {0, 0}, {1, 1}, IM_COL32_WHITE, points(6));
    else
        list.AddRectFilled(corner, end, ImGui::GetColorU32(palette::well), points(6));
    if (picture && !picture->budget.passive())
        drawWarning(list, {end.x - points(3), corner.y});
}

/// Picture and name; returns whether it was chosen.
bool tile(const LibrarySurface& surface, const ShelfPicture* picture, bool current)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 size{points(tileWidth), points(tileHeight)};
    const bool chosen = ImGui::InvisibleButton(surface.id.c_str(), size);
    const bool touched = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    surfaceTooltip(surface, picture);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (touched || current)
        list.AddRectFilled(start, {start.x + size.x, start.y + size.y},
                           ImGui::GetColorU32(current ? palette::chosen : palette::raised), points(8));
    drawPicture(list, {start.x + (size.x - points(pictureSide)) / 2, start.y + points(4)}, picture);
    ImGui::PushFont(face(Face::Small));
    const std::string name = elided(surface.name, size.x - points(8));
    ImGui::PopFont();
    const float width = sizeIn(Face::Small, name).x;
    drawText(list, Face::Small, {start.x + (size.x - width) / 2, start.y + points(pictureSide + 6)},
             touched || current ? palette::text : palette::quiet, name);
    return chosen;
}

void drawTile(ExplorerState& state, const LibrarySurface& surface)
{
    SurfaceShelf& shelf = state.shelf;
    Surface& inHand = surfaceInHand(state.compare, state.scene);
    const auto found = shelf.pictures.find(surface.id);
    const ShelfPicture* picture = found == shelf.pictures.end() ? nullptr : &found->second;
    const bool current = inHand.model == surface.group->model && isSurface(surface, inHand.values);
    if (tile(surface, picture, current))
        applyFromShelf(shelf, surface, inHand);
    if (ImGui::IsItemVisible() && (!picture || picture->stale))
        shelf.wanted.push_back(surface.id);
}

} // namespace

void drawSurfacesPage(ExplorerState& state)
{
    const auto found = searchSurfaces(state.shelf.search, state.shelf.group);
    drawHead(state, found.size());
    ImGui::BeginChild("##tiles");
    scrollBarTooltip("More surfaces: drag, or turn the wheel.");
    const float gap = points(4);
    const auto columns =
        std::max(1, static_cast<int>((ImGui::GetContentRegionAvail().x + gap) / (points(tileWidth) + gap)));
    const auto rows = (static_cast<int>(found.size()) + columns - 1) / columns;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
    ImGuiListClipper clipper;
    clipper.Begin(rows, points(tileHeight) + gap);
    while (clipper.Step())
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
            for (int i = row * columns; i < std::min((row + 1) * columns, static_cast<int>(found.size())); ++i) {
                if (i > row * columns)
                    ImGui::SameLine();
                drawTile(state, *found[static_cast<std::size_t>(i)]);
            }
    ImGui::PopStyleVar();
    ImGui::EndChild();
    if (found.empty())
        remark("No surface has all these words.");
}

} // namespace reflectance::explorer
