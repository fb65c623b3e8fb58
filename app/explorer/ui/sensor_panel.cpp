#include "app/explorer/ui/sensor_panel.h"

#include "app/explorer/ui/card.h"
#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <cmath>

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
    drawCount("clipped", counts.clipped, "Pixels with a channel above 1 after exposure: they are shown as 255.",
              palette::warning);
    ImGui::SameLine(0, points(14));
    drawCount("negative", counts.negative,
              "Pixels with a channel below 0: they are shown as 0. K has negative entries.", palette::warning);
    ImGui::SameLine(0, points(14));
    drawCount("not finite", counts.nonFinite, "Pixels with a NaN or infinite channel: they are shown as 0.",
              palette::error);
}

} // namespace

void drawSensorPanel(ExplorerState& state)
{
    const double exposure = state.scene.sensor.exposure;
    const Card card({3, "Sensor", "sRGB, 8 bit, \u00D7" + general(std::exp2(exposure), 3),
                     "From linear radiance to code values: exposure, clipping, the sRGB curve, 8 bits.", true});
    if (!card.isOpen())
        return;
    numberRow(exposureRow(), state.scene.sensor.exposure, state.message);
    rowLabel("", "Encoding");
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("sRGB, 8 bit");
    tooltip("The exact sRGB curve (IEC 61966-2-1), then rounding to 0 \u2026 255. EXR and PFM pictures keep linear "
            "values.");
    if (state.sensorCounts)
        drawCounts(*state.sensorCounts);
}

} // namespace reflectance::explorer
