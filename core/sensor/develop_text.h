// The shared text with a sensor's inputs set. Internal to core/sensor.
#pragma once

#include "core/sensor/sensor.h"
#include "sensor_texts.gen.h"

namespace reflectance {

using DevelopText = texts::Develop<double>;

/// Holds no copy of a response's curve: the sensor has to outlive it.
[[nodiscard]] DevelopText developText(const Sensor& sensor);

} // namespace reflectance
