// Saving what a renderer made: through the sensor for .png, linear for .exr and .pfm.
#pragma once

#include "core/base/result.h"
#include "core/image/notes.h"
#include "core/sensor/sensor.h"

#include <string>

namespace reflectance {

/// Writes the picture by the name's ending and says what the sensor could not show.
[[nodiscard]] Result<SensorCounts> savePicture(const std::string& path, const Image& image, const Sensor& sensor,
                                               const Notes& notes = {});

} // namespace reflectance
