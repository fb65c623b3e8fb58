#include "app/explorer/ui/workbench/sensor_page.h"

#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

struct StepText {
    const char* step;
    const char* label;
    const char* about;
};

constexpr StepText texts[] = {
    {"model", "Model", "From variant B, taken for the truth, to the scene's surface; both in double."},
    {"precision", "Precision", "From double to what this driver's shader drew, on the same samples."},
    {"sensor", "Sensor", "Vignetting, noise, full well, white balance, matrix and response."},
    {"encoding", "Encoding", "Encoding and quantisation, decoded again as a reader of the PNG would."}};

const StepText* textOf(const std::string& step)
{
    const auto found =
        std::find_if(std::begin(texts), std::end(texts), [&](const StepText& t) { return step == t.step; });
    return found == std::end(texts) ? nullptr : found;
}

/// A bar that begins where the one before ended, so that the last one ends at the whole.
void drawBar(const WaterfallStep& step, double from, ImVec2 topLeft, ImVec2 size)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](double share) { return topLeft.x + size.x * static_cast<float>(std::clamp(share, 0.0, 1.0)); };
    list.AddRectFilled(topLeft, {topLeft.x + size.x, topLeft.y + size.y}, ImGui::GetColorU32(palette::well), points(2));
    const float left = std::min(at(from), at(from + step.share));
    const float right = std::max(at(from), at(from + step.share));
    list.AddRectFilled({left, topLeft.y}, {std::max(right, left + 1.0F), topLeft.y + size.y},
                       ImGui::GetColorU32(step.share < 0.0 ? palette::warning : palette::accent), points(2));
}

void drawStep(const WaterfallStep& step, double from, float barWidth)
{
    const StepText* text = textOf(step.step);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    ImGui::InvisibleButton(step.step.c_str(), {ImGui::GetContentRegionAvail().x, height});
    tooltip(std::string(text ? text->about : "") + "\nRoot mean square change " + written(step.rmse, 3) + ", largest " +
            written(step.maxAbs, 3) +
            " (1 is white).\nShare: sum(d D) / sum(D D), d what this step changes, D what all do.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = start.y + (height - sizeIn(Face::Body, "0").y) / 2;
    drawText(list, Face::Body, {start.x, line}, palette::text, text ? text->label : step.step);
    const float barLeft = start.x + points(90);
    drawBar(step, from, {barLeft, start.y + height * 0.25F}, {barWidth, height * 0.5F});
    const std::string share = general(100.0 * step.share, 3) + " %";
    const float right = barLeft + barWidth + points(72);
    drawText(list, Face::Body, {right - sizeIn(Face::Body, share).x, line}, palette::text, share);
    drawText(list, Face::Small, {right + points(16), start.y + (height - sizeIn(Face::Small, "0").y) / 2},
             palette::quiet, "rmse " + written(step.rmse, 2) + ", largest " + written(step.maxAbs, 2));
}

} // namespace

void drawSensorPage(ExplorerState& state)
{
    remark("Where the difference between the picture's codes and the truth comes from, in the order of the light.",
           palette::text, Face::Body);
    const SensorStudy& study = state.sensorStudy;
    if (!study.waterfall)
        return remark(study.running ? "Shading the picture in double\u2026"
                                    : "Once the picture rests, it is measured.");
    const float barWidth = std::clamp(ImGui::GetContentRegionAvail().x - points(400), points(60), points(520));
    double from = 0.0;
    for (const WaterfallStep& step : study.waterfall->steps) {
        drawStep(step, from, barWidth);
        from += step.share;
    }
    const Waterfall& all = *study.waterfall;
    remark("All together: rmse " + written(all.rmse, 3) + ", largest " + written(all.maxAbs, 3) +
           (all.leftOut > 0 ? "; " + grouped(all.leftOut) + " channels are no numbers and left out." : "."));
    if (!state.scene.other)
        remark("The model has no part in it: compare with a variant B, and B is taken for the truth.");
    remark("The mesh is taken as it is: render --waterfall --truth SCENE.json adds geometry.");
}

} // namespace reflectance::explorer
