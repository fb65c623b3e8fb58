// Numbers as colours that the colour-blind can order, too.
#pragma once

#include "core/chart/chart.h"

namespace reflectance {

/// From dark to bright, evenly to the eye: share 0 .. 1, beyond which the ends stay. The course of viridis (Smith and van
/// der Walt 2015, CC0), between nine of its colours.
[[nodiscard]] ChartColor sequentialColor(double share);

/// Blue for negative, orange for positive, grey for 0: share -1 .. 1, beyond which the ends stay.
[[nodiscard]] ChartColor divergingColor(double share);

} // namespace reflectance
