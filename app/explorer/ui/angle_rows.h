// The angles that several plots are about, one row each. True while a hand changes it.
#pragma once

#include "app/explorer/state.h"

#include <optional>

namespace reflectance::explorer {

/// Degrees, from 0 on.
struct IncidenceRow {
    const char* about;
    double sliderMax, legalMax, initial;
};
bool incidenceRow(const IncidenceRow& limits, double& thetaI, std::optional<Message>& message);

/// Between the azimuths of light and viewer, degrees from 0 to 180.
bool azimuthRow(double& deltaPhi, std::optional<Message>& message);

} // namespace reflectance::explorer
