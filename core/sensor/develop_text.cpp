#include "core/sensor/develop_text.h"

#include "core/sensor/inputs.h"

#include <algorithm>

namespace reflectance {
namespace {

void setLinearParts(DevelopText& text, const SensorInputs& inputs)
{
    text.gain = inputs.gain;
    text.vignettingKind = inputs.vignettingKind;
    text.cornerTangent = inputs.cornerTangent;
    text.fallOff = inputs.fallOff;
    text.noiseOn = inputs.noiseOn;
    text.shotVariance = inputs.shotVariance;
    text.readVariance = inputs.readVariance;
    text.seed = inputs.seed;
    text.wellOn = inputs.wellOn;
    text.wellLimit = inputs.wellLimit;
    text.balanceOn = inputs.balanceOn;
    text.balanceRed = inputs.balanceRows[0];
    text.balanceGreen = inputs.balanceRows[1];
    text.balanceBlue = inputs.balanceRows[2];
}

} // namespace

DevelopText developText(const Sensor& sensor)
{
    const SensorInputs inputs = inputsOf(sensor);
    DevelopText text{};
    setLinearParts(text, inputs);
    text.responseKind = inputs.responseKind;
    text.responsePower = inputs.responsePower;
    text.responseCount = inputs.responseCount;
    if (sensor.response.curve)
        text.responseTexels.numbers = sensor.response.curve->numbers.data();
    text.encoding = inputs.encoding;
    text.levels = inputs.levels;
    text.dithered = inputs.dithered;
    text.viewKind = inputs.viewKind;
    text.marks = inputs.marks;
    const auto colors = falseColors();
    std::copy(colors.begin(), colors.end(), std::begin(text.falseColors));
    return text;
}

} // namespace reflectance
