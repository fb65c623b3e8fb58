// What was traced in the plane of incidence, with error bars, and formulas over it.
#pragma once

#include "core/chart/chart.h"
#include "core/study/goniometer/formula_gap.h"

namespace reflectance {

struct NamedFactor {
    std::string name;
    FactorFunction factor;
};

/// The angle of incidence of the grid nearest to thetaI (radians): its index.
[[nodiscard]] std::size_t nearestIncidence(const LabSetup& setup, double thetaI);

/// The factor pi f (N.L) over the viewing angle, positive away from the light: dots with one standard error, formulas as lines.
[[nodiscard]] Chart planeChart(const LabRun& run, const std::string& name, std::size_t incidence,
                               const std::vector<NamedFactor>& formulas);
/// The dots alone, to be put beside others.
[[nodiscard]] Series tracedSeries(const LabRun& run, const std::string& name, std::size_t incidence, ChartColor color);
[[nodiscard]] Series formulaSeries(const NamedFactor& formula, double thetaI, ChartColor color);

/// pi f as a lobe about the point of incidence: one standard error as bars, formulas as curves.
[[nodiscard]] PolarChart lobeChart(const LabRun& run, const std::string& name, std::size_t incidence,
                                   const std::vector<NamedFactor>& formulas);

} // namespace reflectance
