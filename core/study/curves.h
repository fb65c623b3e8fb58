// A surface as curves in the plane of incidence: what leaves towards each viewer for one light.
#pragma once

#include "core/chart/chart.h"
#include "core/reflectance/catalogue.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// Factor: pi f (N.L), what the program shows. Brdf: f in 1/sr. BrdfCosine: f (N.L), radiance per irradiance on a surface
/// that faces the light.
enum class Quantity { Factor, Brdf, BrdfCosine };

/// "factor (pi f cos theta_i)", for axes.
[[nodiscard]] std::string_view labelOf(Quantity quantity);

/// How the three channels become one number.
enum class Shown { Mean, Red, Green, Blue };

/// A surface with its name and colour in a chart.
struct NamedSurface {
    std::string name;
    ChartColor color = 0;
    const Model* model = nullptr;
    std::vector<double> values;     ///< the model's flat list
    MeasuredSurfaces measured = {}; ///< of a model that looks a table up; who names it keeps it alive
};

struct CurveSettings {
    double thetaI = 0.7; ///< radians from N to L, 0 <= thetaI < pi/2
    Quantity quantity = Quantity::Factor;
    Shown shown = Shown::Mean;
    AxisScale scale = AxisScale::Linear; ///< of overTheta's value axis
};

/// One number of a factor: the channel shown, in the unit of the quantity; `cosine` is N.L.
[[nodiscard]] double numberOf(const Vec3d& factor, double cosine, const CurveSettings& settings);

/// "BRDF f (1/sr), red": what such a number is, for axes.
[[nodiscard]] std::string valueLabel(const CurveSettings& settings);

/// Whether what is seen at this angle counts for the length of an axis: some models grow without bound in the last degrees
/// above the horizon, and would make every other curve a line.
[[nodiscard]] bool setsTheScale(double theta, double thetaI);

/// The direction at this angle in the plane of incidence, N = (0,0,1); positive away from the light.
[[nodiscard]] Vec3d directionInPlane(double theta);

/// Viewing angles from -pi/2 to pi/2, half a degree apart, closer about the mirrored direction: a highlight of n = 1e7 is
/// met by dozens. Positive is away from the light.
[[nodiscard]] std::vector<double> viewingAngles(double thetaI);

/// The surface towards viewers above N = (0,0,1), in double; white light of strength 1 in the plane of x and z, at
/// -thetaI. A light at exactly 90 degrees has no f. Lights have no extent, so a mirror is 0 everywhere.
[[nodiscard]] std::vector<double> towards(const NamedSurface& surface, const CurveSettings& settings,
                                          std::span<const Vec3d> viewers);

/// The same at viewing angles in the plane of incidence.
[[nodiscard]] std::vector<double> inPlane(const NamedSurface& surface, const CurveSettings& settings,
                                          const std::vector<double>& thetaR);

/// One curve per surface over theta_r.
[[nodiscard]] Chart overTheta(const std::vector<NamedSurface>& surfaces, const CurveSettings& settings);

/// The same about the point of incidence, with rays towards L and its mirror image R.
[[nodiscard]] PolarChart aboutThePoint(const std::vector<NamedSurface>& surfaces, const CurveSettings& settings);

} // namespace reflectance
