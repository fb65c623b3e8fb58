// A measured surface as maps over theta_i and theta_r: its numbers, and what they lack of reciprocity.
#pragma once

#include "core/chart/heat_map.h"
#include "core/measured/measurement.h"

#include <functional>
#include <optional>
#include <string>

namespace reflectance {

struct TableMapSettings {
    double deltaPhi = 180.0;  ///< degrees between the azimuths of L and V: 180 holds the mirror direction
    int row = -1, column = 0; ///< the entry of the matrix that is shown; row -1: the mean of the diagonal
    bool logarithmic = true;
    std::size_t steps = 90; ///< cells from 0 to 90 degrees
};

/// A number for unit L and V about N = (0,0,1); nothing where there is none.
using AngleFunction = std::function<std::optional<double>(const Vec3d& L, const Vec3d& V)>;

/// Each cell is asked for at its middle. A logarithmic scale spans at most six powers of ten below the largest number.
/// `label` names the numbers. The matrix entry of the settings is the function's own affair.
[[nodiscard]] HeatMap angleMap(const AngleFunction& function, const TableMapSettings& settings, std::string label);

/// f in 1/sr; each cell is looked up at its middle, as the measurement's own format means it.
[[nodiscard]] HeatMap valueMap(const Measurement& measurement, const TableMapSettings& settings);

/// f over theta_r for one theta_i (degrees), on both sides of the normal: positive angles at the settings' azimuth, negative
/// ones opposite. Holes interrupt the curve.
[[nodiscard]] PolarChart polarSlice(const Measurement& measurement, double thetaI, const TableMapSettings& settings);

/// f(theta_i, theta_r) - f(theta_r, theta_i), mean over the channels.
[[nodiscard]] HeatMap residualMap(const Measurement& measurement, const TableMapSettings& settings);

} // namespace reflectance
