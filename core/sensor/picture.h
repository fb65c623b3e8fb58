// Saving what a renderer made: through the sensor for .png, linear for .exr and .pfm.
#pragma once

#include "core/base/result.h"
#include "core/image/notes.h"
#include "core/sensor/sensor.h"

#include <string>

namespace reflectance {

/// Writes the picture by the name's ending, with notes where its format has a place for them, and says what the sensor could
/// not show. A PNG has 16 bits where the sensor has more than 8, and says how it is encoded; a measured or gamma response
/// beside sRGB or Rec. 709 belongs to the picture, not to its encoding.
[[nodiscard]] Result<SensorCounts> savePicture(const std::string& path, const Image& image, const Sensor& sensor,
                                               const Notes& notes = {});

/// What a PNG has to say of the sensor's codes.
[[nodiscard]] PngColor pngColorOf(const Sensor& sensor);

} // namespace reflectance
