#include "app/explorer/ui/lens_legend.h"

#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/study/lens/palette.h"

#include <algorithm>
#include <array>

namespace reflectance::explorer {

namespace {

ImU32 inkOf(const Rgb8& rgb)
{
    return IM_COL32(rgb[0], rgb[1], rgb[2], 255);
}

std::size_t countOf(const LensFigures& figures, LensMark mark)
{
    switch (mark) {
    case LensMark::NotANumber:
        return figures.notANumber;
    case LensMark::Infinite:
        return figures.infinite;
    case LensMark::Negative:
        return figures.negative;
    case LensMark::AbovePassive:
        return figures.abovePassive;
    case LensMark::Background:
    case LensMark::Digits:
        break;
    }
    return 0;
}

void drawKinds(ExplorerState& state)
{
    constexpr std::array<Choice, 4> kinds{{
        {"float", "Scalar single precision against double."},
        {"half", "Single precision, the picture kept in 16-bit floats: 3.3 digits, nothing beyond 65504."},
        {"simd", "Single precision in lanes against double."},
        {"glsl", "What this driver's shader draws against double."},
    }};
    if (const int chosen = choiceRow(kinds, static_cast<int>(*state.lens)); chosen >= 0)
        state.lens = lensKinds[chosen];
}

/// The scale from 0 digits to what the arithmetic has.
void drawRamp(LensKind kind)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, points(12)};
    const double most = mostDigits(kind);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    constexpr int pieces = 48;
    const float width = size.x / pieces;
    for (int i = 0; i < pieces; ++i) {
        const float left = start.x + width * static_cast<float>(i);
        list.AddRectFilled({left, start.y}, {left + width + 1.0F, start.y + size.y},
                           inkOf(colorOfDigits(most * (i + 0.5) / pieces)));
    }
    ImGui::InvisibleButton("##ramp", size);
    tooltip("Significant digits that this arithmetic keeps of double: light has lost them, dark has kept them.");
    const std::string right = general(most, 2) + " digits kept";
    const float below = ImGui::GetCursorScreenPos().y;
    drawText(list, Face::Small, {start.x + size.x - sizeIn(Face::Small, right).x, below}, palette::quiet, right);
    remark("0");
}

/// A line for every mark that the picture has.
void drawMarks(const LensFigures& figures)
{
    for (const LensLegend& line : lensLegend()) {
        const std::size_t count = countOf(figures, line.mark);
        if (count == 0)
            continue;
        const ImVec2 start = ImGui::GetCursorScreenPos();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float side = points(11);
        for (int x = 0; x < static_cast<int>(side); ++x)
            for (int y = 0; y < static_cast<int>(side); ++y)
                list.AddRectFilled({start.x + static_cast<float>(x), start.y + static_cast<float>(y)},
                                   {start.x + static_cast<float>(x + 1), start.y + static_cast<float>(y + 1)},
                                   inkOf(colorOf({line.mark, 0.0F}, x, y)));
        ImGui::Dummy({side, side});
        ImGui::SameLine();
        remark(std::string(line.name) + ": " + grouped(count) + " pixels", palette::text);
        tooltip(line.about);
    }
}

std::string summary(const ExplorerState& state)
{
    if (!state.lensFigures)
        return "The lens lies over the picture once it rests.";
    const LensFigures& figures = *state.lensFigures;
    return "median " + general(figures.median, 2) + ", fewest " + general(figures.fewest, 2) + " digits";
}

std::string numbers(const Vec3d& v)
{
    return written(v.x, 8) + "  " + written(v.y, 8) + "  " + written(v.z, 8);
}

} // namespace

void drawLensLegend(ExplorerState& state, ImVec2 bottomRight)
{
    const float marks =
        state.lensFigures
            ? static_cast<float>(std::ranges::count_if(
                  lensLegend(), [&](const auto& line) { return countOf(*state.lensFigures, line.mark) > 0; }))
            : 0.0F;
    const ImVec2 size{points(250), points(104) + marks * points(19)};
    ImGui::SetCursorScreenPos({bottomRight.x - size.x, bottomRight.y - size.y});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::floating);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {points(10), points(8)});
    ImGui::BeginChild("##lens legend", size, true,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                          ImGuiWindowFlags_AlwaysUseWindowPadding);
    drawKinds(state);
    drawRamp(*state.lens);
    remark(summary(state), palette::text);
    tooltip("Over the pixels that the object covers whole and that are painted by digits.");
    if (state.lensFigures)
        drawMarks(*state.lensFigures);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

std::string lensSentence(LensKind kind, const LensPixel& pixel)
{
    if (pixel.mark == LensMark::Background)
        return "The background shows here; the lens looks at pixels that the object covers whole.";
    for (const LensLegend& line : lensLegend())
        if (line.mark == pixel.mark)
            return line.about;
    return std::string(nameOf(kind)) + " keeps " + general(static_cast<double>(pixel.digits), 2) + " of " +
           general(mostDigits(kind), 2) + " digits.";
}

void showLensReading(LensKind kind, const LensReading& reading)
{
    beginTooltip();
    ImGui::TextUnformatted(lensSentence(kind, reading.pixel).c_str());
    if (reading.pixel.mark != LensMark::Background) {
        remark(reading.term, palette::accent, Face::Body);
        remark(std::string(nameOf(kind)) + "  " + numbers(reading.got));
        remark("double  " + numbers(reading.exact));
        remark("rounding is magnified up to " + written(reading.kappa, 2) + " times");
    }
    endTooltip();
}

} // namespace reflectance::explorer
