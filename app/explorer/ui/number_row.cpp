#include "app/explorer/ui/number_row.h"

#include "app/explorer/ui/formula_view.h"
#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <imgui_internal.h>

namespace reflectance::explorer {

namespace {

/// Fine enough to be exact while dragging, coarse enough to be read.
std::string formatFor(const NumberRow& row)
{
    const char* digits = row.logarithmic ? "%.4g" : row.sliderMax - row.sliderMin > 5.0 ? "%.1f" : "%.3f";
    return row.unit.empty() ? digits : digits + std::string(row.unit == "\u00B0" ? "" : "\u2009") + row.unit;
}

/// 0 .. 1 along the slider.
float shareOf(const NumberRow& row, double value)
{
    double share = (value - row.sliderMin) / (row.sliderMax - row.sliderMin);
    if (row.logarithmic)
        share = value > 0.0 ? std::log(value / row.sliderMin) / std::log(row.sliderMax / row.sliderMin) : 0.0;
    return static_cast<float>(std::clamp(share, 0.0, 1.0));
}

/// Two ticks, above and below the digits, so that the mark of the value never covers the value.
void drawTicks(ImDrawList& list, float x, float top, float height)
{
    const float tick = points(4);
    const float half = points(1);
    const ImU32 color = ImGui::GetColorU32(palette::accent);
    list.AddRectFilled({x - half, top}, {x + half, top + tick}, color);
    list.AddRectFilled({x - half, top + height - tick}, {x + half, top + height}, color);
}

/// The well and its filled part, which grows from 0 where the range has both signs.
void drawWell(const NumberRow& row, double value, ImVec2 topLeft, ImVec2 size)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    const ImVec2 bottomRight{topLeft.x + size.x, topLeft.y + size.y};
    list.AddRectFilled(topLeft, bottomRight, ImGui::GetColorU32(palette::well), rounding);
    const float zero = row.logarithmic ? 0.0F : shareOf(row, 0.0);
    const float here = shareOf(row, value);
    const float from = topLeft.x + size.x * std::min(zero, here);
    const float to = topLeft.x + size.x * std::max(zero, here);
    if (to - from >= 1.0F) {
        list.PushClipRect({from, topLeft.y}, {to, bottomRight.y}, true);
        list.AddRectFilled(topLeft, bottomRight, ImGui::GetColorU32(palette::fill), rounding);
        list.PopClipRect();
    }
    const float mark = topLeft.x + std::clamp(size.x * here, points(2), size.x - points(2));
    drawTicks(list, mark, topLeft.y, size.y);
}

void drawRange(const NumberRow& row, ImVec2 topLeft, ImVec2 size)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string low = rangeEnd(row.sliderMin);
    const std::string high = rangeEnd(row.sliderMax);
    const ImVec2 highSize = sizeIn(Face::Small, high);
    const float top = topLeft.y + (size.y - highSize.y) / 2;
    drawText(list, Face::Small, {topLeft.x + points(7), top}, palette::quiet, low);
    drawText(list, Face::Small, {topLeft.x + size.x - points(7) - highSize.x, top}, palette::quiet, high);
}

void drawTooltip(const NumberRow& row, double value)
{
    if (!tooltipIsDue())
        return;
    beginTooltip();
    ImGui::PushFont(face(Face::Strong));
    ImGui::TextUnformatted(row.label.c_str());
    ImGui::PopFont();
    ImGui::TextUnformatted(row.about.c_str());
    if (!row.formula.empty())
        drawFormula(row.formula, points(320));
    const std::string unit = row.unit.empty() ? "" : " " + row.unit;
    remark("value " + shortest(value) + unit + ",  default " + shortest(row.initial) + unit);
    remark("slider " + rangeEnd(row.sliderMin) + " \u2026 " + rangeEnd(row.sliderMax) +
           (row.logarithmic ? " (logarithmic)" : "") + ",  legal " + rangeEnd(row.legalMin) + " \u2026 " +
           rangeEnd(row.legalMax));
    if (!row.source.empty())
        remark("source: " + row.source);
    remark("Double-click: default.  Ctrl+click: type.", palette::accent);
    endTooltip();
}

bool isLegal(const NumberRow& row, double value)
{
    return std::isfinite(value) && value >= row.legalMin && value <= row.legalMax;
}

std::string refusal(const NumberRow& row, double value)
{
    return row.label + " cannot be " + shortest(value) + "; it takes " + rangeEnd(row.legalMin) + " to " +
           rangeEnd(row.legalMax) + (row.unit.empty() ? "" : " " + row.unit);
}

/// Slider, reset and check; the well has been drawn. The slider's own frame and grab stay clear.
bool editedBySlider(const NumberRow& row, double& value, std::optional<Message>& message)
{
    double edited = value;
    const std::string format = formatFor(row);
    for (const ImGuiCol color : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_SliderGrab,
                                 ImGuiCol_SliderGrabActive})
        ImGui::PushStyleColor(color, IM_COL32_BLACK_TRANS);
    ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 1.0F); // so that the fill ends where the mouse is
    const ImGuiSliderFlags flags = row.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    bool changed = ImGui::SliderScalar("##value", ImGuiDataType_Double, &edited, &row.sliderMin, &row.sliderMax,
                                       format.c_str(), flags);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(5);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        ImGui::ClearActiveID(); // else the held button would go on dragging from where it is
        edited = row.initial;
        changed = true;
    }
    if (!changed || edited == value)
        return false;
    if (!isLegal(row, edited)) {
        message = Message{refusal(row, edited), true};
        return false;
    }
    value = edited;
    return true;
}

} // namespace

std::string rangeEnd(double value)
{
    if (std::isinf(value))
        return value > 0 ? "\u221E" : "\u2212\u221E";
    const std::string digits = written(std::abs(value), 4);
    return value < 0 ? "\u2212" + digits : digits;
}

bool numberField(const NumberRow& row, double& value, float width, std::optional<Message>& message)
{
    ImGui::PushID(row.name.c_str());
    drawWell(row, value, ImGui::GetCursorScreenPos(), {width, ImGui::GetFrameHeight()});
    ImGui::SetNextItemWidth(width);
    const bool changed = editedBySlider(row, value, message);
    drawTooltip(row, value);
    ImGui::PopID();
    return changed;
}

bool numberRow(const NumberRow& row, double& value, std::optional<Message>& message)
{
    rowLabel(row.symbol, row.label);
    const ImVec2 topLeft = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()};
    const bool changed = numberField(row, value, size.x, message);
    if (!ImGui::IsItemActive() || !ImGui::GetIO().WantTextInput)
        drawRange(row, topLeft, size);
    return changed;
}

} // namespace reflectance::explorer
