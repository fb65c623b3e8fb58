// What a measurement says about itself: reciprocity, albedo, and how well its samples tell each other.
#pragma once

#include "core/measured/measurement.h"

namespace reflectance {

/// f(i, r) - f(r, i), mean over the channels, at one difference of azimuths: a map over theta_i (rows) and theta_r.
struct ReciprocityMap {
    std::vector<double> theta;    ///< radians, of rows and of columns
    double deltaPhi = 0.0;        ///< radians
    std::vector<double> residual; ///< 1/sr, row by row; NaN where one of the two is a hole
    double rms = 0.0;   ///< of the residual over that of f, weighted by both cosines and solid angles: 0.03 is 3 %
    double worst = 0.0; ///< largest |residual|, over the largest f met: most often at grazing angles
};

/// `steps` + 1 angles from 0 to 90 degrees, the last one left out.
[[nodiscard]] ReciprocityMap reciprocityMap(const Measurement& measurement, double deltaPhi, std::size_t steps);

/// rms and worst over differences of azimuth 0, 15 ... 180 degrees together, and polar angles 0, 5 ... up to `limit`.
struct Reciprocity {
    double limit = 0.0; ///< radians
    double rms = 0.0, worst = 0.0;
    std::size_t compared = 0;
};
[[nodiscard]] Reciprocity reciprocityOf(const Measurement& measurement, double limit);

/// The share of light from thetaI that is reflected into the directions that the measurement knows, for white light, per
/// channel; `known` is the share of the hemisphere, weighted by the cosine, that these make up.
struct Albedo {
    double thetaI = 0.0; ///< radians
    Vec3d value;
    double known = 0.0;
    double uncertainty = 0.0; ///< how much the last refinement of the quadrature changed it
};
[[nodiscard]] Albedo albedoAt(const Measurement& measurement, double thetaI);

/// How well the interpolation tells a sample from the others, as if it had not been measured.
struct LeftOut {
    std::string along;    ///< the angle along which the neighbours lie; "all" for scattered samples
    double rms = 0.0;     ///< of the error, over the rms of the samples
    double worst = 0.0;   ///< largest |error|, over the largest sample
    std::size_t told = 0; ///< samples with neighbours on both sides
};

/// For a table one entry per angle: a sample is told from its neighbours along that angle, so the interval is twice as wide
/// as the table's own, and a smooth surface's true error about a quarter of what is found. RGL's parameterisation has no such
/// neighbours: empty.
[[nodiscard]] std::vector<LeftOut> leaveOneOut(const Measurement& measurement);

} // namespace reflectance
