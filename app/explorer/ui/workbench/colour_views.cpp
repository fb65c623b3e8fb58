#include "app/explorer/ui/workbench/colour_views.h"

#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/sensor/sensor.h"
#include "core/spectra/builtin.h"
#include "core/spectra/metamers.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

constexpr ChartColor inks[] = {0xD55E00, 0x009E73, 0x0072B2};

Series seriesOf(const Spectrum& spectrum, std::string name, ChartColor color, bool toItsLargest)
{
    Series series;
    series.name = std::move(name);
    series.color = color;
    double largest = 0.0;
    for (double nm = 380.0; nm <= 730.0; nm += 1.0) {
        series.x.push_back(nm);
        series.y.push_back(spectrum.at(nm));
        largest = std::max(largest, std::fabs(series.y.back()));
    }
    for (double& y : series.y)
        y /= toItsLargest && largest > 0.0 ? largest : 1.0;
    return series;
}

ImU32 codeOf(const Vec3d& linear)
{
    const auto code = [](double channel) { return int{quantised(encodeSrgb(std::clamp(channel, 0.0, 1.0)))}; };
    return IM_COL32(code(linear.x), code(linear.y), code(linear.z), 255);
}

void drawNumber(ImVec2 topLeft, float width, double value)
{
    const std::string text = std::fabs(value) < 5e-5 ? "0" : general(std::round(value * 1e4) / 1e4, 4);
    const ImVec2 size = sizeIn(Face::Body, text);
    drawText(*ImGui::GetWindowDrawList(), Face::Body, {topLeft.x + width - size.x, topLeft.y},
             value < 0.0 ? palette::warning : palette::text, text);
}

void drawPriceLine(const ColourPage& page)
{
    const CheatPrice& price = page.answer->prices[static_cast<std::size_t>(page.cheat)];
    const auto shown = [](double deltaE) { return deltaE < 0.005 ? "0" : general(deltaE, 2); };
    remark(std::string(wordsFor(page.cheat)) + ": dE2000 " + shown(price.mean) + " mean, " + shown(price.p95) +
               " p95, " + shown(price.max) + " max",
           price.max > 2.3 ? palette::warning : palette::text);
    tooltip("Against the spectral integral, over the 24 patches under this light. About 1 is just visible.");
}

void drawPatch(const ColourPage& page, std::size_t patch, ImVec2 topLeft, ImVec2 size)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = topLeft.y + 0.5F * size.y;
    const ImVec2 end{topLeft.x + size.x, topLeft.y + size.y};
    list.AddRectFilled(topLeft, {end.x, middle}, codeOf(page.answer->truth[patch]));
    list.AddRectFilled({topLeft.x, middle}, end,
                       codeOf(page.answer->byCheat[static_cast<std::size_t>(page.cheat)][patch]));
    if (patch == page.patch)
        list.AddRect({topLeft.x - 1, topLeft.y - 1}, {end.x + 1, end.y + 1}, palette::accent, 0.0F, 0, points(2));
}

/// Two halves without a seam: what differs is seen as an edge.
void drawTwins(const Vec3d& own, const Vec3d& twin, ImVec2 topLeft, ImVec2 size)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = std::round(topLeft.x + 0.5F * size.x);
    list.AddRectFilled(topLeft, {middle, topLeft.y + size.y}, codeOf(own));
    list.AddRectFilled({middle, topLeft.y}, {topLeft.x + size.x, topLeft.y + size.y}, codeOf(twin));
}

void drawTwinsUnder(const std::string& light, double apart, const Vec3d& own, const Vec3d& twin, ImVec2 size)
{
    const std::string text = light + ": dE2000 " + (apart < 0.005 ? "0" : general(apart, 2));
    remark(elided(text, size.x), apart > 1.0 ? palette::warning : palette::text);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(("pair under " + light).c_str(), {std::max(size.x, 1.0F), std::max(size.y, 1.0F)});
    tooltip("Left the patch, right its twin: another reflectance with the same K. Under " + light +
            " they are dE2000 " + general(apart, 3) + " apart by the spectral integral; every K says 0.");
    drawTwins(own, twin, start, size);
}

} // namespace

Chart spectraChart(const ColorAnswer& answer, std::size_t patch)
{
    Chart chart;
    chart.x = {"wavelength (nm)", 380.0, 730.0, AxisScale::Linear, 50.0};
    chart.y = {"relative", 0.0, 1.05, AxisScale::Linear, 0.0};
    for (std::size_t c = 0; c < 3; ++c)
        chart.series.push_back(seriesOf(answer.sensors[c], c == 0 ? "filters" : "", inks[c], true));
    for (std::size_t c = 0; c < 3; ++c) {
        chart.series.push_back(seriesOf(answer.primaries[c], c == 0 ? "primaries" : "", inks[c], true));
        chart.series.back().dashed = true;
    }
    chart.series.push_back(seriesOf(colorChecker()[patch], colorChecker()[patch].name, 0x888888, false));
    return chart;
}

void drawDerivedMatrix(const ColourPage& page, ImVec2 size)
{
    ImGui::BeginChild("matrix", size, false, ImGuiWindowFlags_NavFlattened);
    const JudgedSurface& patch = page.answer->patches[page.patch];
    const Mat3d& K = page.convention == Convention::Primary ? patch.M : patch.K;
    remark("K of " + patch.name + ", " + std::string(nameOf(page.convention)) + " convention");
    tooltip("Row: sensor. Column: light. Negative entries are normal in the sensor convention.");
    const float cell = (ImGui::GetContentRegionAvail().x - points(4)) / 3;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeightWithSpacing();
    const auto numbers = rowByRow(K);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            drawNumber({start.x + cell * static_cast<float>(column), start.y + height * static_cast<float>(row)}, cell,
                       numbers[3 * row + column]);
    ImGui::Dummy({3 * cell, 3 * height + points(4)});
    double off = 0.0;
    double diagonal = 0.0;
    for (std::size_t i = 0; i < 9; ++i)
        (i % 4 == 0 ? diagonal : off) += std::fabs(numbers[i]);
    remark("\u03A3|off| / \u03A3|diag| = " + general(off / diagonal, 3), palette::text);
    tooltip("The size of what a diagonal K leaves out.");
    remark("condition of W " + general(page.answer->system.condition, 3));
    tooltip("How much errors grow on the way from what the sensor sees back to primaries.");
    if (!page.answer->system.makesWhite) {
        remark("These primaries cannot make the sensor's white.", palette::warning);
        tooltip("One of them would have to be negative.");
    }
    drawPriceLine(page);
    ImGui::EndChild();
}

void drawPatches(ColourPage& page, ImVec2 size)
{
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float gap = points(3);
    const ImVec2 patch{(size.x - 5 * gap) / 6, (size.y - 3 * gap) / 4};
    for (std::size_t i = 0; i < page.answer->patches.size(); ++i) {
        const std::size_t row = i / 6, column = i % 6;
        const ImVec2 topLeft{start.x + static_cast<float>(column) * (patch.x + gap),
                             start.y + static_cast<float>(row) * (patch.y + gap)};
        ImGui::SetCursorScreenPos(topLeft);
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::InvisibleButton("patch", {std::max(patch.x, 1.0F), std::max(patch.y, 1.0F)}))
            page.patch = i;
        const CheatPrice& price = page.answer->prices[static_cast<std::size_t>(page.cheat)];
        tooltip(page.answer->patches[i].name + ": dE2000 " + general(price.each[i], 3) +
                ". Above the spectral truth, below the " + std::string(wordsFor(page.cheat)) + ".");
        ImGui::PopID();
        drawPatch(page, i, topLeft, patch);
    }
}

void drawPair(const ColourPage& page, ImVec2 size)
{
    const ColorAnswer& answer = *page.answer;
    const MetamericPair pair =
        metamericPair(answer.system, xyzFromSensor(answer.system), answer.patches[page.patch], answer.light);
    ImGui::BeginChild("metamers", size, false, ImGuiWindowFlags_NavFlattened);
    const ImVec2 half{size.x, std::max(points(12), 0.5F * size.y - ImGui::GetTextLineHeightWithSpacing() - points(6))};
    drawTwinsUnder("white of the primaries", pair.apartUnderWhite, pair.ownUnderWhite, pair.twinUnderWhite, half);
    drawTwinsUnder(answer.light.name, pair.apartUnderLight, pair.ownUnderLight, pair.twinUnderLight, half);
    ImGui::EndChild();
}

} // namespace reflectance::explorer
