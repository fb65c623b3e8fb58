#include "app/explorer/ui/compare_overlay.h"

#include "app/explorer/ui/piece.h"
#include "app/explorer/ui/rung_row.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/image/compare.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reflectance::explorer {

namespace {

constexpr std::array<Choice, 4> modes = {{
    // in the order of CompareMode
    {"Side by side", "A on the left, B on the right, under one camera and the same lights."},
    {"Wipe", "One picture, A left and B right of a divider; drag it."},
    {"Flip", "A and B in the same place, one at a time: X flips."},
    {"Difference",
     "B less A in luminance: blue where B is darker, red where it is brighter, white where they are equal."},
}};

} // namespace

float compareBarHeight()
{
    return ImGui::GetFrameHeight() + sizeIn(Face::Small, "0").y + points(20);
}

float compareBarWidth(float pictureWidth)
{
    return std::min(points(440), pictureWidth - points(16));
}

namespace {

void drawModes(ExplorerState& state, const Area& area)
{
    const float width = compareBarWidth(area.width);
    const float height = compareBarHeight();
    beginPiece("##compare", {std::round(area.x + (area.width - width) / 2), area.y + points(8)}, {width, height});
    const int pressed = choiceRow(modes, static_cast<int>(state.compare.mode));
    if (pressed >= 0)
        state.compare.mode = static_cast<CompareMode>(pressed);
    const auto& figures = state.compare.figures;
    ImGui::PushFont(face(Face::Small));
    const std::string text = elided(figuresText(figures), ImGui::GetContentRegionAvail().x);
    ImGui::PopFont();
    remark(text, figures && figures->identical ? palette::good : palette::text);
    tooltip(
        "B against A over the pixels of the object, linear before the sensor: root mean square and largest difference "
        "of a channel. dE2000 is how visible it is on a display: about 1 is the smallest difference that an eye "
        "sees side by side; p95 is exceeded by one pixel in twenty. FLIP, 0 .. 1, is how strongly the two would "
        "flicker on a screen (Andersson et al. 2020). Ctrl+drag a rectangle to take the figures there, Ctrl+click for "
        "the whole object.");
    ImGui::EndChild();
}

/// The rectangle that the figures are of.
void drawRegion(const CompareView& compare, const Area& pane)
{
    if (!compare.region)
        return;
    const auto x = [&](double share) { return pane.x + static_cast<float>(share) * pane.width; };
    const auto y = [&](double share) { return pane.y + static_cast<float>(share) * pane.height; };
    const ImVec2 topLeft{x(compare.region->left), y(compare.region->top)};
    const ImVec2 bottomRight{x(compare.region->right), y(compare.region->bottom)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRect(topLeft, bottomRight, IM_COL32(0, 0, 0, 160), 0.0F, 0, points(3));
    list.AddRect(topLeft, bottomRight, palette::text, 0.0F, 0, points(1.5F));
}

/// The variant's name, as a button that puts the hand on it.
void drawName(ExplorerState& state, bool isB, const Area& pane, bool atRight)
{
    const Surface& surface = isB && state.scene.other ? *state.scene.other : state.scene.surface;
    const auto model = findModelOf(surface);
    const std::string rungs = surface.rungs.empty() ? "" : "   " + rungsText(surface);
    const std::string name = std::string(isB ? "B   " : "A   ") + (model ? (*model)->text.name : surface.model) + rungs;
    const float most = pane.width - points(16);
    const float width = std::min(sizeIn(Face::Body, name).x + points(20), most);
    const float height = ImGui::GetFrameHeight();
    const float x = atRight ? pane.right() - points(8) - width : pane.x + points(8);
    ImGui::SetCursorScreenPos({x, pane.bottom() - points(8) - height});
    ImGui::BeginChild(isB ? "##name B" : "##name A", {width, height}, false, stillWindow);
    const std::string shown = elided(name, width - points(12));
    if (toggleButton((shown + "##name").c_str(), state.compare.handOnB == isB, {width, height}))
        state.compare.handOnB = isB;
    tooltip(std::string("Variant ") + (isB ? "B" : "A") + ": click, and the Surface panel changes it.  X");
    ImGui::EndChild();
}

void drawDivider(ExplorerState& state, const Area& area)
{
    CompareView& compare = state.compare;
    const float x = area.x + compare.divider * area.width;
    const float reach = points(7);
    // Between the bar above and the names below.
    const float top = area.y + compareBarHeight() + points(12);
    const float height = std::max(1.0F, area.bottom() - top - ImGui::GetFrameHeight() - points(12));
    ImGui::SetCursorScreenPos({x - reach, top});
    ImGui::BeginChild("##divider", {2 * reach, height}, false, stillWindow | ImGuiWindowFlags_NoBackground);
    ImGui::InvisibleButton("##grip", {2 * reach, height});
    compare.holdsDivider = ImGui::IsItemActive();
    const bool touched = compare.holdsDivider || ImGui::IsItemHovered();
    tooltip("Drag: A on the left, B on the right.");
    if (touched)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (compare.holdsDivider)
        compare.divider = std::clamp((ImGui::GetIO().MousePos.x - area.x) / std::max(1.0F, area.width), 0.02F, 0.98F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({area.x, area.y}, {area.right(), area.bottom()});
    const ImU32 color = ImGui::GetColorU32(touched ? palette::accent : palette::text);
    list.AddLine({x, area.y}, {x, area.bottom()}, color, points(1.5F));
    list.AddCircleFilled({x, area.y + area.height / 2}, points(6), color);
    list.PopClipRect();
    ImGui::EndChild();
}

/// The colours of the map from -1 to 1, asked of the map itself.
const std::vector<std::uint8_t>& ramp()
{
    static const std::vector<std::uint8_t> codes = [] {
        constexpr int steps = 64;
        Image black(steps, 1), grey(steps, 1);
        for (int i = 0; i < steps; ++i)
            std::fill_n(grey.at(i, 0), 3, -1.0F + 2.0F * (static_cast<float>(i) + 0.5F) / static_cast<float>(steps));
        return differenceMap(black, grey, 1.0);
    }();
    return codes;
}

/// "-0.05  [blue to red]  +0.05" with what either end means.
void drawScale(const ExplorerState& state, const Area& area)
{
    const float width = std::min(points(280), area.width - points(16));
    const float line = sizeIn(Face::Small, "0").y;
    const float height = line + points(34);
    beginPiece("##scale", {std::round(area.x + (area.width - width) / 2), area.bottom() - height - points(46)},
               {width, height});
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float across = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({across, line + points(18)});
    tooltip(
        "Difference of linear luminance, B less A; full colour from the ends on. The scale follows the picture: one "
        "pixel in a hundred may lie beyond it.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::vector<std::uint8_t>& codes = ramp();
    const std::size_t steps = codes.size() / 3;
    for (std::size_t i = 0; i < steps; ++i) {
        const float left = start.x + across * static_cast<float>(i) / static_cast<float>(steps);
        const float right = start.x + across * static_cast<float>(i + 1) / static_cast<float>(steps);
        list.AddRectFilled({left, start.y}, {right, start.y + points(10)},
                           IM_COL32(codes[3 * i], codes[3 * i + 1], codes[3 * i + 2], 255));
    }
    const std::string end = general(state.compare.scale, 3);
    const float below = start.y + points(15);
    drawText(list, Face::Small, {start.x, below}, palette::text, "B darker, -" + end);
    const std::string equal = "equal";
    drawText(list, Face::Small, {start.x + (across - sizeIn(Face::Small, equal).x) / 2, below}, palette::text, equal);
    const std::string brighter = "+" + end + ", B brighter";
    drawText(list, Face::Small, {start.x + across - sizeIn(Face::Small, brighter).x, below}, palette::text, brighter);
    ImGui::EndChild();
}

} // namespace

void drawCompareOverlay(ExplorerState& state, const Area& area, const Panes& panes)
{
    if (!state.compare.on)
        return;
    const CompareMode mode = state.compare.mode;
    for (const Area* pane : {&panes.a, &panes.b})
        drawRegion(state.compare, *pane);
    if (mode == CompareMode::Wipe)
        drawDivider(state, area);
    if (mode == CompareMode::Difference)
        drawScale(state, area);
    drawModes(state, area);
    drawName(state, false, panes.a, false);
    drawName(state, true, panes.b, mode != CompareMode::SideBySide);
}

} // namespace reflectance::explorer
