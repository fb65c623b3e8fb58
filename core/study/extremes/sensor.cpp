// H50 to H54: the sensor's curve, its rounding, and what an 8-bit or half-float store would lose.
#include "core/sensor/sensor.h"
#include "core/base/embedded.h"
#include "core/base/text.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace reflectance {
namespace {

/// The standard's curve (IEC 61966-2-1:1999), written apart from the shipped text.
double standardCurve(double x)
{
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::exp(std::log(x) / 2.4) - 0.055;
}

Developed shown(const std::vector<float>& values)
{
    Image image(static_cast<int>(values.size()), 1);
    for (std::size_t i = 0; i < values.size(); ++i)
        std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, values[i]);
    return develop(image, {});
}

Outcome specialValues(Bench&)
{
    const Developed picture = shown({-0.1F, NAN, -INFINITY, INFINITY});
    const auto code = [&](std::size_t i) { return int{picture.rgb[3 * i]}; };
    const bool holds = code(0) == 0 && code(1) == 0 && code(2) == 0 && code(3) == 255 && picture.counts.negative == 2 &&
                       picture.counts.nonFinite == 3;
    return {holds, std::to_string(code(0)) + " " + std::to_string(code(1)) + " " + std::to_string(code(2)) + " " +
                       std::to_string(code(3)) + ", counted " + std::to_string(picture.counts.negative) +
                       " negative, " + std::to_string(picture.counts.nonFinite) + " not finite"};
}

/// The codes that the shared sensor text gives in GLSL. The text runs as if it were a model: I goes in, light comes out.
std::vector<int> codesInGlsl(Bench& bench, const std::vector<double>& values)
{
    const auto text =
        parseModelText("extremes_sensor",
                       std::string(embeddedText("sensor/encode.glsl")) +
                           "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return vec3(encodeSrgb(inRange(I.x))); }\n",
                       {});
    if (!text)
        return {};
    const Vec3d up{0, 0, 1};
    std::vector<Observation> rows;
    for (const double value : values)
        rows.push_back({up, up, {{up, Vec3d(value), 0.0}}});
    std::vector<int> codes;
    for (const Vec3d& encoded : bench.ask({{}, *text, {}, {}, {}}, {}, rows))
        codes.push_back(quantised(encoded.x));
    return codes;
}

Outcome specialValuesInGlsl(Bench& bench)
{
    const std::vector<int> codes = codesInGlsl(bench, {-0.1, NAN, -INFINITY, INFINITY});
    std::string found;
    for (const int code : codes)
        found += (found.empty() ? "" : " ") + std::to_string(code);
    return {codes == std::vector<int>{0, 0, 0, 255}, found};
}

Outcome exactCurveInGlsl(Bench& bench)
{
    std::vector<double> values;
    for (int code = 0; code < 256; ++code)
        values.push_back(static_cast<float>(decodeSrgb(code / 255.0)));
    for (int i = 0; i <= 4096; ++i)
        values.push_back(i / 4096.0);
    const std::vector<int> codes = codesInGlsl(bench, values);
    int wrong = 0;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const double scaled = 255.0 * standardCurve(values[i]);
        // GLSL's pow may be 16 units of 2^-24 off: 2.5e-4 of a code.
        const bool isTie = std::fabs(scaled - std::floor(scaled) - 0.5) < 2.5e-4;
        wrong += isTie || codes[i] == static_cast<int>(std::floor(scaled + 0.5)) ? 0 : 1;
    }
    return {codes.size() == values.size() && wrong == 0, std::to_string(wrong) + " of 4353 wrong"};
}

Outcome ties(Bench&)
{
    int wrong = quantised(0.5) == 128 ? 0 : 1; // 127.5 is the only tie that doubles hold exactly
    for (int code = 0; code < 255; ++code) {
        wrong += quantised((code + 0.5 - 1e-9) / 255.0) == code ? 0 : 1;
        wrong += quantised((code + 0.5 + 1e-9) / 255.0) == code + 1 ? 0 : 1;
    }
    return {wrong == 0, std::to_string(wrong) + " of 511 wrong"};
}

Outcome exactCurve(Bench&)
{
    int lost = 0;
    for (int code = 0; code < 256; ++code)
        lost += shown({static_cast<float>(decodeSrgb(code / 255.0))}).rgb[0] == code ? 0 : 1;
    int wrong = 0;
    for (int i = 0; i <= 4096; ++i) {
        const float linear = static_cast<float>(i) / 4096.0F;
        const double scaled = 255.0 * standardCurve(double{linear});
        const bool isTie = std::fabs(scaled - std::floor(scaled) - 0.5) < 1e-9; // either code is right
        wrong += isTie || int{shown({linear}).rgb[0]} == static_cast<int>(std::floor(scaled + 0.5)) ? 0 : 1;
    }
    return {lost == 0 && wrong == 0,
            std::to_string(lost) + " of 256 lost, " + std::to_string(wrong) + " of 4097 wrong"};
}

Outcome banding(Bench&)
{
    std::set<int> fromBytes;
    for (int code = 0; code < 256; ++code)
        fromBytes.insert(quantised(encodeSrgb(code / 255.0)));
    std::set<int> fromFloats;
    for (int i = 0; i <= 65535; ++i)
        fromFloats.insert(quantised(encodeSrgb(double{static_cast<float>(i) / 65535.0F})));
    const std::vector<int> first(fromBytes.begin(), std::next(fromBytes.begin(), 4));
    double gamma = 0.0;
    for (int i = 0; i <= 10000; ++i)
        gamma = std::max(gamma, 255.0 * std::fabs(std::pow(i / 10000.0, 1.0 / 2.2) - encodeSrgb(i / 10000.0)));
    return {fromBytes.size() == 183 && first == std::vector<int>{0, 13, 22, 28} && fromFloats.size() == 256 &&
                std::fabs(gamma - 8.5) < 0.05,
            std::to_string(fromBytes.size()) + " codes from bytes, " + std::to_string(fromFloats.size()) +
                " from ours; a power of 1/2.2 is " + general(gamma, 2) + " codes off"};
}

double ramp(double x, double)
{
    return x;
}

/// Four bars on grey.
double noLight(double x, double y)
{
    const double values[] = {-0.1, NAN, -INFINITY, INFINITY};
    const double place = 4.0 * x;
    const auto bar = static_cast<std::size_t>(place);
    const bool inside = std::fabs(place - std::floor(place) - 0.5) < 0.3 && std::fabs(y - 0.5) < 0.3;
    return inside ? values[std::min<std::size_t>(bar, 3)] : 0.2;
}

double darkRamp(double x, double y)
{
    const double radiance = 0.06 * x;
    return y < 0.5 ? std::floor(255.0 * radiance + 0.5) / 255.0 : radiance;
}

} // namespace

Hazards sensorHazards() // NOLINT(readability-function-size): a list
{
    const Show rampSeen = seenRadiance(
        ramp, "Radiance from 0 at the left to 1 at the right, through this driver's curve: even steps to the eye.");
    const Show noLightSeen = seenRadiance(noLight, "From the left: -0.1, NaN, -infinity, +infinity, on grey. Three are "
                                                   "black, one is white, and the sensor counts them.");
    return {
        {.id = "H50",
         .danger = "a half-float buffer",
         .input = "65504, 65519, 65520, 1e6",
         .expected = "65504 from there on",
         .precisions = {},
         .show = unseen("There is no half-float buffer. The lens shows what one would keep."),
         .missing = "half-float buffer: linear pictures are float"},
        {"H51",
         "the curve of what is no light",
         "-0.1, NaN, -infinity, +infinity",
         "0 0 0 255, counted 2 negative, 3 not finite",
         {},
         {},
         specialValues,
         noLightSeen},
        {"H52",
         "ties in quantisation",
         "1/2 and (k + 1/2 +- 1e-9) / 255",
         "floor(255 x + 1/2): 0 of 511 wrong",
         {},
         {},
         ties,
         rampSeen},
        {"H53",
         "the sRGB curve",
         "256 codes there and back; 4097 linear values",
         "0 lost, 0 wrong",
         {},
         {},
         exactCurve,
         rampSeen},
        {"H54",
         "banding",
         "linear ramps of 256 and 65536 steps",
         "183 codes from bytes (0, 13, 22, 28, ..), 256 from ours; 1/2.2 is 8.5 off",
         {},
         {},
         banding,
         seenRadiance(darkRamp,
                      "Above, a dark ramp kept in bytes before the sensor: steps. Below, the same ramp in floats.")},
        {"H51",
         "the shader's curve of what is no light",
         "-0.1, NaN, -infinity, +infinity",
         "0 0 0 255",
         {Precision::Glsl},
         {},
         specialValuesInGlsl,
         noLightSeen},
        {"H53",
         "the shader's sRGB curve",
         "256 codes and 4097 linear values",
         "0 wrong, ties to 2.5e-4 apart",
         {Precision::Glsl},
         {},
         exactCurveInGlsl,
         rampSeen},
    };
}

} // namespace reflectance
