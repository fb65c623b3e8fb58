// The fitted curve over the measurement, in the plane of incidence.
#pragma once

#include "core/chart/chart.h"
#include "core/measured/measurement.h"
#include "core/reflectance/catalogue.h"

namespace reflectance {

/// What leaves towards each viewer for a light at thetaI (radians, 0 <= thetaI < pi/2), mean of the channels for white light:
/// pi f, or with `cosine` pi f (N.L). The measurement is dots at every other degree, with gaps where it has holes; the model is a line.
/// Viewing angles are degrees, positive away from the light; `flat` is the model's list of values.
[[nodiscard]] Chart chartInPlane(const Measurement& measurement, const Model& model, const std::vector<double>& flat,
                                 double thetaI, bool cosine);

/// Of some round angles of incidence the one at which the measurement shows most of the plane.
[[nodiscard]] double usualIncidence(const Measurement& measurement);

} // namespace reflectance
