#include "app/explorer/ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui_internal.h>

namespace reflectance::explorer {

namespace {

constexpr float tooltipDelay = 0.45F; // seconds of rest

/// Start of the character before `end`: bytes 10xxxxxx continue one.
std::size_t previousCharacter(std::string_view text, std::size_t end)
{
    do
        --end;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80);
    return end;
}

/// A tooltip finds its size in the frame after the one that knows its text: until then it must be drawn again.
struct LastTooltip {
    ImGuiID item = 0;
    int frame = -1, frames = 0; ///< when it was drawn last, and how often in a row
};
LastTooltip lastTooltip;
constexpr int framesToSettle = 3;

void noteTooltip()
{
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    if (lastTooltip.frame == g.FrameCount)
        return;
    const bool goesOn = lastTooltip.item == g.HoveredId && lastTooltip.frame == g.FrameCount - 1;
    lastTooltip = {g.HoveredId, g.FrameCount, goesOn ? lastTooltip.frames + 1 : 1};
}

} // namespace

ImVec2 sizeIn(Face which, std::string_view text)
{
    const ImFont& font = *face(which);
    return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0F, text.data(), text.data() + text.size());
}

void drawText(ImDrawList& list, Face which, ImVec2 topLeft, ImU32 color, std::string_view text)
{
    const ImFont* font = face(which);
    list.AddText(font, font->FontSize, {std::round(topLeft.x), std::round(topLeft.y)}, ImGui::GetColorU32(color),
                 text.data(), text.data() + text.size());
}

bool tooltipIsDue()
{
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        return false;
    // A held mouse button is a drag: a tooltip would only hide what it changes.
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left))
        return false;
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    return g.HoveredId == 0 || g.HoveredIdTimer >= tooltipDelay;
}

bool waitsForTime()
{
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    const bool settles = lastTooltip.frame == g.FrameCount && lastTooltip.frames < framesToSettle;
    return settles || g.IO.WantTextInput || (g.HoveredId != 0 && g.HoveredIdTimer < tooltipDelay + 0.1F);
}

void beginTooltip()
{
    noteTooltip();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {points(10), points(8)});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(points(340));
}

void endTooltip()
{
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void tooltip(std::string_view text)
{
    if (text.empty() || !tooltipIsDue())
        return;
    beginTooltip();
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    endTooltip();
}

void scrollBarTooltip(std::string_view text)
{
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    if (g.HoveredId != ImGui::GetWindowScrollbarID(g.CurrentWindow, ImGuiAxis_Y) || g.HoveredIdTimer < tooltipDelay ||
        ImGui::IsMouseDown(ImGuiMouseButton_Left))
        return;
    beginTooltip();
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    endTooltip();
}

void remark(std::string_view text, ImU32 color, Face which)
{
    ImGui::PushFont(face(which));
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

float symbolWidth(std::string_view symbol)
{
    const std::size_t bar = symbol.find('_');
    const float base = sizeIn(Face::Italic, symbol.substr(0, bar)).x;
    return bar == symbol.npos ? base : base + sizeIn(Face::ItalicSmall, symbol.substr(bar + 1)).x;
}

void drawSymbol(ImDrawList& list, ImVec2 baselineLeft, std::string_view symbol, ImU32 color)
{
    const std::size_t bar = symbol.find('_');
    const std::string_view base = symbol.substr(0, bar);
    drawText(list, Face::Italic, {baselineLeft.x, baselineLeft.y - face(Face::Italic)->Ascent}, color, base);
    if (bar == symbol.npos)
        return;
    const float left = baselineLeft.x + sizeIn(Face::Italic, base).x;
    const float lowered = baselineLeft.y + points(3.5F) - face(Face::ItalicSmall)->Ascent;
    drawText(list, Face::ItalicSmall, {left, lowered}, color, symbol.substr(bar + 1));
}

void rowLabel(std::string_view symbol, std::string_view label, ImU32 color)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float labelWidth = std::round(ImGui::GetContentRegionAvail().x * 0.46F);
    const float baseline = start.y + ImGui::GetStyle().FramePadding.y + face(Face::Body)->Ascent;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float x = start.x;
    if (!symbol.empty()) {
        drawSymbol(list, {x, baseline}, symbol, palette::accent);
        x += std::max(symbolWidth(symbol) + points(5), points(20));
    }
    const std::string shown = elided(label, start.x + labelWidth - points(4) - x);
    drawText(list, Face::Body, {x, start.y + ImGui::GetStyle().FramePadding.y}, color, shown);
    ImGui::SetCursorScreenPos({start.x + labelWidth, start.y});
    ImGui::SetNextItemWidth(-1.0F);
}

bool toggleButton(const char* label, bool on, ImVec2 size)
{
    ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::chosen : palette::raised);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, on ? palette::chosen : palette::hovered);
    const bool pressed = ImGui::Button(label, size);
    ImGui::PopStyleColor(2);
    return pressed;
}

int choiceRow(std::span<const Choice> choices, int current)
{
    const float gap = points(2);
    const auto count = static_cast<float>(choices.size());
    float textWidth = 0.0F;
    for (const Choice& choice : choices)
        textWidth += sizeIn(Face::Body, choice.label).x;
    const float padding = (ImGui::GetContentRegionAvail().x - textWidth - (count - 1.0F) * gap) / count;
    int pressed = -1;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0F, ImGui::GetStyle().FramePadding.y});
    for (int i = 0; i < static_cast<int>(choices.size()); ++i) {
        const Choice& choice = choices[static_cast<std::size_t>(i)];
        if (i > 0)
            ImGui::SameLine(0, gap);
        if (toggleButton(choice.label, i == current, {sizeIn(Face::Body, choice.label).x + padding, 0}))
            pressed = i;
        tooltip(choice.about);
    }
    ImGui::PopStyleVar();
    return pressed;
}

bool fold(const char* label, const char* about)
{
    ImGui::PushStyleColor(ImGuiCol_Text, palette::quiet);
    ImGui::PushFont(face(Face::Small));
    const bool open = ImGui::TreeNodeEx(label, ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    ImGui::PopFont();
    ImGui::PopStyleColor();
    tooltip(about);
    return open;
}

bool beginMenu(const char* id, const char* shown)
{
    // The arrow belongs to the field; a button of its own would be one thing too many to look at.
    ImGui::PushStyleColor(ImGuiCol_Button, palette::well);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::well);
    const bool open = ImGui::BeginCombo(id, shown, ImGuiComboFlags_HeightLargest);
    ImGui::PopStyleColor(2);
    return open;
}

std::string elided(std::string_view text, float width)
{
    const ImFont& font = *ImGui::GetFont();
    const auto widthOf = [&](std::string_view t) {
        return font.CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0.0F, t.data(), t.data() + t.size()).x;
    };
    if (widthOf(text) <= width)
        return std::string(text);
    constexpr std::string_view ellipsis = "\u2026";
    std::size_t end = text.size();
    while (end > 0 && widthOf(text.substr(0, end)) + widthOf(ellipsis) > width)
        end = previousCharacter(text, end);
    while (end > 0 && text[end - 1] == ' ')
        --end;
    return std::string(text.substr(0, end)) + std::string(ellipsis);
}

} // namespace reflectance::explorer
