#include "app/explorer/ui/card.h"

#include "app/explorer/ui/widgets.h"

#include <cmath>

namespace reflectance::explorer {

namespace {

void drawBadge(ImDrawList& list, ImVec2 centre, int number)
{
    list.AddCircleFilled(centre, points(11), ImGui::GetColorU32(palette::chosen));
    const std::string digit = std::to_string(number);
    const ImVec2 size = sizeIn(Face::Strong, digit);
    drawText(list, Face::Strong, {centre.x - size.x / 2, centre.y - size.y / 2}, palette::text, digit);
}

void drawFoldArrow(ImDrawList& list, ImVec2 centre, bool open)
{
    const float r = points(4);
    const ImU32 color = ImGui::GetColorU32(palette::quiet);
    if (open)
        list.AddTriangleFilled({centre.x - r, centre.y - r / 2}, {centre.x + r, centre.y - r / 2},
                               {centre.x, centre.y + r / 2}, color);
    else
        list.AddTriangleFilled({centre.x - r / 2, centre.y - r}, {centre.x + r / 2, centre.y},
                               {centre.x - r / 2, centre.y + r}, color);
}

/// The heading is one wide button; returns whether the card is open.
bool drawHeading(const CardHeading& heading)
{
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID openId = ImGui::GetID("open");
    bool open = storage.GetBool(openId, true);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, points(26)};
    if (ImGui::InvisibleButton("heading", size)) {
        open = !open;
        storage.SetBool(openId, open);
    }
    const bool hovered = ImGui::IsItemHovered();
    tooltip(heading.about);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = start.y + size.y / 2;
    drawBadge(list, {start.x + points(11), middle}, heading.number);
    const ImVec2 titleSize = sizeIn(Face::Strong, heading.title);
    const float titleLeft = start.x + points(32);
    drawText(list, Face::Strong, {titleLeft, middle - titleSize.y / 2}, hovered ? palette::accent : palette::text,
             heading.title);
    drawFoldArrow(list, {start.x + size.x - points(6), middle}, open);

    const float right = start.x + size.x - points(20);
    ImGui::PushFont(face(Face::Small));
    const std::string summary = elided(heading.summary, right - titleLeft - titleSize.x - points(12));
    ImGui::PopFont();
    const ImVec2 summarySize = sizeIn(Face::Small, summary);
    drawText(list, Face::Small, {right - summarySize.x, middle - summarySize.y / 2}, palette::quiet, summary);
    return open;
}

void drawArrowToNext(ImVec2 top, float height)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(palette::quiet);
    const float tip = points(4);
    list.AddLine({top.x, top.y + points(1)}, {top.x, top.y + height - points(2)}, color, points(1.5F));
    list.AddTriangleFilled({top.x - tip, top.y + height - points(1) - tip},
                           {top.x + tip, top.y + height - points(1) - tip}, {top.x, top.y + height - points(1)}, color);
}

} // namespace

Card::Card(const CardHeading& heading) : last_(heading.last)
{
    ImDrawList* list = ImGui::GetWindowDrawList();
    layers_.Split(list, 2);
    layers_.SetCurrentChannel(list, 1);
    ImGui::BeginGroup();
    ImGui::PushID(heading.title);
    // A table of one column gives the card its inner margin on both sides.
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {points(12), points(8)});
    ImGui::BeginTable("card", 1, ImGuiTableFlags_PadOuterX | ImGuiTableFlags_SizingStretchSame);
    ImGui::PopStyleVar();
    ImGui::TableNextColumn();
    open_ = drawHeading(heading);
}

Card::~Card()
{
    ImGui::EndTable();
    ImGui::PopID();
    ImGui::EndGroup();
    const ImVec2 topLeft = ImGui::GetItemRectMin();
    const ImVec2 bottomRight = ImGui::GetItemRectMax();
    ImDrawList* list = ImGui::GetWindowDrawList();
    layers_.SetCurrentChannel(list, 0);
    list->AddRectFilled(topLeft, bottomRight, ImGui::GetColorU32(palette::card), points(8));
    layers_.Merge(list);
    if (last_)
        return;
    const float gap = points(16);
    drawArrowToNext({topLeft.x + points(23), bottomRight.y}, gap);
    ImGui::SetCursorScreenPos({topLeft.x, bottomRight.y + gap});
}

} // namespace reflectance::explorer
