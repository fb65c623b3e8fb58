// The sensor's part of a scene file.
#pragma once

#include "core/scene/json_reader.h"
#include "core/sensor/sensor.h"

namespace reflectance {

/// A part that is named is on, unless it says "on": false. `resolve` finds the files that it names.
void readSensor(ObjectReader object, Sensor& sensor, const std::function<std::string(const std::string&)>& resolve);

/// The exposure, and every part that differs from the default. `shorten` writes the names of files.
[[nodiscard]] ObjectReader::Json writtenSensor(const Sensor& sensor,
                                               const std::function<std::string(const std::string&)>& shorten);

} // namespace reflectance
