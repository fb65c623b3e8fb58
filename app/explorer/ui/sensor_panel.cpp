#include "app/explorer/ui/sensor_panel.h"

#include "app/explorer/ui/card.h"
#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/sensor_parts.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <array>

namespace reflectance::explorer {

namespace {

NumberRow exposureRow()
{
    NumberRow row;
    row.name = "exposure";
    row.label = "Exposure";
    row.unit = "EV";
    row.about = "Radiance is multiplied by 2 to the power of EV before it is encoded: +1 doubles it.";
    row.sliderMin = -8.0;
    row.sliderMax = 8.0;
    row.legalMin = -16.0;
    row.legalMax = 16.0;
    return row;
}

void drawCount(const char* name, std::size_t count, const char* about, ImU32 color)
{
    remark(std::to_string(count) + " " + name, count > 0 ? color : palette::quiet);
    tooltip(about);
}

void drawCounts(const SensorCounts& counts)
{
    drawCount("clipped", counts.clipped, "Pixels with a channel that the full well or the largest code cuts off.",
              palette::warning);
    ImGui::SameLine(0, points(14));
    drawCount("negative", counts.negative,
              "Pixels with a channel below 0: they are shown as 0. K has negative entries.", palette::warning);
    ImGui::SameLine(0, points(14));
    drawCount("not finite", counts.nonFinite, "Pixels with a NaN or infinite channel: they are shown as 0.",
              palette::error);
}

void drawView(SensorView& view)
{
    static constexpr std::array<Choice, 3> kinds = {{
        {"picture", "The picture in its colours."},
        {"luminance", "0.2126 R + 0.7152 G + 0.0722 B of the linear values, as a grey."},
        {"false colour", "One colour for each stop of luminance; the legend stands in the picture."},
    }};
    if (const int pressed = choiceRow(kinds, static_cast<int>(view.kind)); pressed >= 0)
        view.kind = static_cast<SensorViewKind>(pressed);
    ImGui::Checkbox("mark what cannot be shown", &view.marks);
    tooltip("Stripes: orange where a channel is clipped, blue where one is negative; magenta where one is no number.");
}

} // namespace

void drawSensorPanel(ExplorerState& state)
{
    Sensor& sensor = state.scene.sensor;
    const std::string parts = sensorPartsSummary(sensor);
    const Card card({3, "Sensor", (parts.empty() ? "sRGB, 8 bit" : parts) + ", \u00D7" + general(gainOf(sensor), 3),
                     "From linear radiance to code values, as a chain of parts that can be switched one by one.",
                     true});
    if (!card.isOpen())
        return;
    numberRow(exposureRow(), sensor.exposure, state.message);
    drawView(sensor.view);
    if (fold("Parts",
             "Camera, vignetting, noise, full well, white balance, response, encoding and quantisation. EXR and "
             "PFM pictures keep the linear values before them."))
        drawSensorParts(state);
    if (state.sensorCounts)
        drawCounts(*state.sensorCounts);
}

} // namespace reflectance::explorer
