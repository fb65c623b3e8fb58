#include "core/sensor/inputs.h"

#include "core/chart/color_map.h"
#include "core/math/angle.h"

#include <cmath>

namespace reflectance {
namespace {

void setBalance(SensorInputs& inputs, const Balance& balance)
{
    inputs.balanceOn = balance.on ? 1 : 0;
    for (std::size_t row = 0; row < 3; ++row) {
        const double* m = &balance.matrix[3 * row];
        inputs.balanceRows[row] = Vec3d{m[0], m[1], m[2]} * balance.gains;
    }
}

void setNoise(SensorInputs& inputs, const Sensor& sensor)
{
    const double electrons = electronsAtWhite(sensor);
    inputs.noiseOn = sensor.noise.on ? 1 : 0;
    inputs.shotVariance = sensor.noise.shot ? 1.0 / electrons : 0.0;
    inputs.readVariance = (sensor.noise.read / electrons) * (sensor.noise.read / electrons);
    inputs.seed = sensor.noise.seed;
}

void setResponse(SensorInputs& inputs, const Response& response)
{
    if (!response.on)
        return;
    inputs.responsePower = 1.0 / response.gamma;
    inputs.responseKind = response.kind == ResponseKind::Gamma ? 1 : response.curve ? 2 : 0;
    inputs.responseCount = response.curve ? response.curve->count() : 0;
}

} // namespace

bool isAlikeEverywhere(const SensorInputs& inputs)
{
    return inputs.vignettingKind == 0 && inputs.noiseOn == 0 && inputs.dithered == 0 && inputs.marks == 0;
}

SensorInputs inputsOf(const Sensor& sensor)
{
    SensorInputs inputs;
    inputs.gain = gainOf(sensor);
    const Vignetting& vignetting = sensor.vignetting;
    inputs.vignettingKind = !vignetting.on ? 0 : vignetting.kind == FallOff::Cos4 ? 1 : 2;
    inputs.cornerTangent = std::tan(radians(vignetting.corner));
    inputs.fallOff = vignetting.polynomial;
    setNoise(inputs, sensor);
    inputs.wellOn = sensor.well.on ? 1 : 0;
    inputs.wellLimit = sensor.well.limit;
    setBalance(inputs, sensor.balance);
    setResponse(inputs, sensor.response);
    inputs.encoding = sensor.encoding.on ? static_cast<int>(sensor.encoding.kind) : 0;
    inputs.levels = sensor.quantisation.on ? std::ldexp(1.0, sensor.quantisation.bits) - 1.0 : 0.0;
    inputs.dithered = sensor.quantisation.dither ? 1 : 0;
    inputs.viewKind = static_cast<int>(sensor.view.kind);
    inputs.marks = sensor.view.marks ? 1 : 0;
    return inputs;
}

std::array<float, 3 * falseColorBands> falseColors()
{
    std::array<float, 3 * falseColorBands> colors{};
    for (std::size_t band = 0; band < falseColorBands; ++band) {
        const ChartColor color = sequentialColor(static_cast<double>(band) / static_cast<double>(falseColorBands - 1));
        for (std::size_t c = 0; c < 3; ++c)
            colors[3 * band + c] = static_cast<float>((color >> (16 - 8 * c)) & 0xFFU) / 255.0F;
    }
    return colors;
}

} // namespace reflectance
