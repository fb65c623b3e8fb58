// The three stages of a probed point as columns: light, surface, sensor.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

/// The point and the lights that reach it; a click on a light's name fills the formula in for that light.
void drawProbedLights(ProbeStudy& study, const Probe& probe);

/// The formula with the numbers of one light, its terms, and the sum over the lights.
void drawProbedSurface(ProbeStudy& study, const Probe& probe);

/// What the sensor makes of the sum, and what GL drew there; `name` is "A" or "B" where two are compared, else empty.
void drawProbedSensor(const Probe& probe, const std::optional<ProbedPixel>& pixel, const std::string& name);

} // namespace reflectance::explorer
