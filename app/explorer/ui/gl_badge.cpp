#include "app/explorer/ui/gl_badge.h"

#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/widgets.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

std::string placeOf(const GlPixel& pixel)
{
    return "(" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
}

std::string boundShare(const GlPixel& pixel)
{
    return std::isfinite(pixel.ratio) ? written(pixel.ratio, 2) + " of its bound" : "no number";
}

std::string aboutCheck(const ExplorerState& state, const GlCheck& check)
{
    return "GL against double on this driver (" + state.renderer + "), at " + grouped(check.pixels) +
           " pixels of the picture at rest, each on the samples that GL drew.\nLargest difference " +
           written(check.largestDifference, 2) + ". Nearest to its bound: pixel " + placeOf(check.worst) + ", " +
           boundShare(check.worst) +
           ".\nThe bound is 64 (kappa + 1) 2^-23 of the value, kappa what the formula magnifies rounding by.\n" +
           (state.markWorstPixel ? "Click to take the mark off that pixel." : "Click to mark that pixel.");
}

std::string numbers(const Vec3d& v)
{
    return written(v.x, 7) + "  " + written(v.y, 7) + "  " + written(v.z, 7);
}

/// The values of the worst pixel, in a box beside the ring.
void drawValues(const GlPixel& pixel, ImVec2 centre, ImVec2 low, ImVec2 high)
{
    const std::string lines[] = {"pixel " + placeOf(pixel), "GL      " + numbers(pixel.drawn),
                                 "double  " + numbers(pixel.exact),
                                 "difference " + written(pixel.difference, 3) + ", bound " + written(pixel.bound, 3)};
    ImVec2 size{0, 0};
    for (const std::string& line : lines)
        size = {std::max(size.x, sizeIn(Face::Small, line).x), size.y + sizeIn(Face::Small, line).y + points(2)};
    size = {size.x + points(20), size.y + points(14)};
    const float reach = points(16);
    ImVec2 corner{centre.x + reach, centre.y + reach};
    if (corner.x + size.x > high.x)
        corner.x = centre.x - reach - size.x;
    if (corner.y + size.y > high.y)
        corner.y = centre.y - reach - size.y;
    corner = {std::max(corner.x, low.x), std::max(corner.y, low.y)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, palette::floating, points(6));
    ImVec2 at{corner.x + points(10), corner.y + points(7)};
    for (const std::string& line : lines) {
        drawText(list, Face::Small, at, palette::text, line);
        at.y += sizeIn(Face::Small, line).y + points(2);
    }
}

} // namespace

Badge badgeOf(const ExplorerState& state)
{
    if (!state.glCheck)
        return {"GL\u2026", "Once the picture rests, GL is held against double on this driver.", palette::quiet};
    const GlCheck& check = *state.glCheck;
    if (check.pixels == 0)
        return {"GL: nothing to check", "The object covers no pixel whole.", palette::quiet};
    if (check.holds())
        return {"GL = double to " + written(check.largestDifference, 2), aboutCheck(state, check), palette::good};
    return {"GL differs from double at " + placeOf(check.worst),
            grouped(check.beyond) + " pixels are beyond their bound.\n" + aboutCheck(state, check), palette::error};
}

float glBadgeWidth(const ExplorerState& state)
{
    return sizeIn(Face::Small, badgeOf(state).text).x + points(30);
}

void drawGlBadge(ExplorerState& state, ImVec2 topLeft)
{
    const Badge badge = badgeOf(state);
    const ImVec2 text = sizeIn(Face::Small, badge.text);
    const ImVec2 size{glBadgeWidth(state), text.y + points(10)};
    ImGui::SetCursorScreenPos(topLeft);
    if (ImGui::InvisibleButton("##gl badge", size))
        state.markWorstPixel = !state.markWorstPixel;
    const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    tooltip(badge.about);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 ground = (hovered ? palette::hovered : palette::floating) & 0xD8FFFFFFU; // the picture shines through
    list.AddRectFilled(topLeft, {topLeft.x + size.x, topLeft.y + size.y}, ground, size.y / 2);
    list.AddCircleFilled({topLeft.x + points(13), topLeft.y + size.y / 2}, points(4), badge.color);
    drawText(list, Face::Small, {topLeft.x + points(22), topLeft.y + (size.y - text.y) / 2},
             state.glCheck && !state.glCheck->holds() ? palette::error : palette::text, badge.text);
}

bool worstPixelIsMarked(const ExplorerState& state)
{
    return state.glCheck && state.glCheck->pixels > 0 && (state.markWorstPixel || !state.glCheck->holds());
}

void drawWorstPixel(ExplorerState& state, ImVec2 centre, ImVec2 low, ImVec2 high)
{
    const GlPixel& pixel = state.glCheck->worst;
    const float radius = points(11);
    ImGui::SetCursorScreenPos({centre.x - radius, centre.y - radius});
    if (ImGui::InvisibleButton("##worst pixel", {2 * radius, 2 * radius}))
        state.worstPixelSelected = !state.worstPixelSelected;
    tooltip("The pixel that is nearest to its bound, or furthest beyond. Click for its values.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = state.glCheck->holds() ? palette::good : palette::error;
    list.AddCircle(centre, radius, IM_COL32(0, 0, 0, 160), 32, points(4));
    list.AddCircle(centre, radius, color, 32, points(2));
    if (state.worstPixelSelected)
        drawValues(pixel, centre, low, high);
}

} // namespace reflectance::explorer
