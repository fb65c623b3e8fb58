#include "app/explorer/ui/message_toast.h"
#include "app/explorer/ui/session_offer.h"
#include "app/explorer/ui/status_texts.h"
#include "app/explorer/ui/ui.h"
#include "app/explorer/ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace reflectance::explorer {

namespace {

float spacing()
{
    return points(18);
}

PartWidth widthOf(const StatusPart& part)
{
    return {sizeIn(Face::Small, part.full).x + spacing(), sizeIn(Face::Small, part.brief).x + spacing(), part.weight};
}

float shownWidth(const PartWidth& width, PartForm form)
{
    return form == PartForm::Full ? width.full : form == PartForm::Brief ? width.brief : 0.0F;
}

void drawPart(const StatusPart& part, PartForm form, ImVec2 topLeft)
{
    const std::string& text = form == PartForm::Full ? part.full : part.brief;
    const ImVec2 size = sizeIn(Face::Small, text);
    ImGui::SetCursorScreenPos({topLeft.x, ImGui::GetWindowPos().y});
    ImGui::Dummy({size.x, statusLineHeight()});
    const bool hovered = ImGui::IsItemHovered();
    tooltip(part.about);
    const ImU32 color = hovered ? palette::text : part.isNews ? palette::accent : palette::quiet;
    drawText(*ImGui::GetWindowDrawList(), Face::Small,
             {topLeft.x, ImGui::GetWindowPos().y + (statusLineHeight() - size.y) / 2}, color, text);
}

/// The left group from the left edge, the right group up to the right edge.
void drawParts(const std::vector<StatusPart>& left, const std::vector<StatusPart>& right, float width)
{
    std::vector<PartWidth> widths;
    for (const auto* group : {&left, &right})
        for (const StatusPart& part : *group)
            widths.push_back(widthOf(part));
    const std::vector<PartForm> forms = formsThatFit(widths, width);
    float rightWidth = 0.0F;
    for (std::size_t i = left.size(); i < widths.size(); ++i)
        rightWidth += shownWidth(widths[i], forms[i]);
    ImVec2 at = ImGui::GetCursorScreenPos();
    const float rightStart = at.x + width - rightWidth + spacing();
    for (std::size_t i = 0; i < widths.size(); ++i) {
        if (i == left.size())
            at.x = rightStart;
        if (forms[i] == PartForm::Gone)
            continue;
        drawPart(i < left.size() ? left[i] : right[i - left.size()], forms[i], at);
        at.x += shownWidth(widths[i], forms[i]);
    }
}

StatusPart loadingPart(const Loading& loading)
{
    const std::string file = std::filesystem::path(loading.file).filename().string();
    const std::string percent =
        std::to_string(static_cast<int>(std::lround(100.0 * std::clamp(loading.done, 0.0, 1.0)))) + " %";
    return {"reading " + file + ", " + percent, "reading " + percent, "Reading " + loading.file + ". Esc stops it.", 9,
            false};
}

void drawProgress(const Loading& loading)
{
    const ImVec2 corner = ImGui::GetWindowPos();
    const auto share = static_cast<float>(std::clamp(loading.done, 0.0, 1.0));
    ImGui::GetWindowDrawList()->AddRectFilled(corner,
                                              {corner.x + share * ImGui::GetWindowWidth(), corner.y + points(2)},
                                              ImGui::GetColorU32(palette::accent));
}

} // namespace

float statusLineHeight()
{
    return points(26);
}

void drawStatusLine(ExplorerState& state)
{
    std::vector<StatusPart> left = pictureParts(state);
    if (state.loading) {
        left.insert(left.begin(), loadingPart(*state.loading));
        drawProgress(*state.loading);
    }
    const ImVec2 corner = ImGui::GetWindowPos();
    drawParts(left, priceParts(state), ImGui::GetContentRegionAvail().x);
    const float offerTop = drawSessionOffer(state, corner);
    drawMessage(state, {corner.x, offerTop}, ImGui::GetWindowWidth());
    state.drawSoon = waitsForTime();
}

} // namespace reflectance::explorer
