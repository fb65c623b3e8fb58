// The sensor in two steps, for who asks how much each of them changes: light as the pixels hold it, and light as the codes stand
// for it.
#pragma once

#include "core/sensor/sensor.h"

namespace reflectance {

/// Times gainOf(sensor), in double: what a perfect sensor would show.
[[nodiscard]] Image exposedLight(const Image& image, const Sensor& sensor);

/// After vignetting, noise, full well, balance and response, before encoding and quantisation.
[[nodiscard]] Image sensedLight(const Image& image, const Sensor& sensor);

/// What the codes of the file stand for, by the inverse of the encoding. A view or marks would be decoded with them: switch
/// them off before.
[[nodiscard]] Image decodedLight(const Developed& developed, const Sensor& sensor);

} // namespace reflectance
