// The sensor's parts and their fields as files and flags name them, in the order in which light passes: scene files, --sensor and
// its help are loops over this list. The first field of a part is the one that a flag sets without naming it.
#pragma once

#include "core/sensor/sensor.h"

#include <string>
#include <string_view>

namespace reflectance {

/// visitor.part(name, part, fields), where fields(part, f) calls f.number(key, value, low, high), f.whole, f.flag,
/// f.choice(key, names, value), f.vector(key, value, low), f.matrix(key, value) and f.curve(key, response).
template <class SensorType, class Visitor> void visitParts(SensorType& sensor, Visitor& visitor)
{
    visitor.part("camera", sensor.camera, [](auto& part, auto& f) {
        f.number("white", part.white, 1e-6, 1e9);
        f.number("aperture", part.aperture, 0.5, 128.0);
        f.number("shutter", part.shutter, 1e-6, 3600.0);
        f.number("iso", part.iso, 1.0, 1e7);
    });
    visitor.part("vignetting", sensor.vignetting, [](auto& part, auto& f) {
        f.choice("kind", fallOffs, part.kind);
        f.number("corner", part.corner, 0.0, 80.0);
        f.vector("polynomial", part.polynomial, -1e6);
    });
    visitor.part("noise", sensor.noise, [](auto& part, auto& f) {
        f.number("read", part.read, 0.0, 1e6);
        f.flag("shot", part.shot);
        f.number("full_well", part.fullWell, 1.0, 1e9);
        f.whole("seed", part.seed, 0, 1'000'000'000);
    });
    visitor.part("well", sensor.well, [](auto& part, auto& f) { f.number("limit", part.limit, 1e-6, 1e6); });
    visitor.part("balance", sensor.balance, [](auto& part, auto& f) {
        f.vector("gains", part.gains, 0.0);
        f.matrix("matrix", part.matrix);
    });
    visitor.part("response", sensor.response, [](auto& part, auto& f) {
        f.choice("kind", responseKinds, part.kind);
        f.number("gamma", part.gamma, 0.1, 10.0);
        f.curve("file", part);
    });
    visitor.part("encoding", sensor.encoding, [](auto& part, auto& f) { f.choice("kind", encodingKinds, part.kind); });
    visitor.part("quantisation", sensor.quantisation, [](auto& part, auto& f) {
        f.whole("bits", part.bits, 1, 16);
        f.flag("dither", part.dither);
    });
}

/// Sets "PART=VALUE[:KEY=VALUE...]", as in "noise=8:seed=3", "quantisation=10" or "well=off". VALUE is on, off, or that of the
/// part's first field; anything but off turns the part on. "all=off" switches every part off. On an error the sensor stays as it was.
[[nodiscard]] Result<void> setOnSensor(std::string_view assignment, Sensor& sensor);

/// The sensor with every part off but this one, exposure and encoding: what the part does by itself.
[[nodiscard]] Sensor onlyPart(const Sensor& sensor, std::string_view part);

/// Reads the curve of a response from a file.
[[nodiscard]] Result<void> readCurveOf(Response& response, const std::string& file);

/// "camera=VALUE[:white=..]" and so on, a line for each part.
[[nodiscard]] std::string sensorGrammar();

} // namespace reflectance
