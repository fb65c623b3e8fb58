// Samples at scattered angles (CUReT, Cornell): f between them by local fits.
#pragma once

#include "core/measured/table.h"

namespace reflectance {

/// How far apart two samples are is counted between points of three numbers, in which isotropy, mirror symmetry and
/// reciprocity are built in:
///     ((theta_h / (pi/2))^power, difference theta_d / (pi/2), heights |cos(theta_i) - cos(theta_r)|)
struct ScatteredMetric {
    double power = 0.5, difference = 1.0, heights = 0.25;
};

/// For surfaces whose samples lie dense about the mirror direction, and for matte ones: found by leaving out samples of the
/// Cornell and CUReT measurements.
inline constexpr ScatteredMetric glossyMetric{0.5, 1.0, 0.25};
inline constexpr ScatteredMetric matteMetric{1.0, 2.0, 0.5};

/// A surface that is taken to be isotropic, mirror-symmetric and reciprocal. f is the value at the point asked for of the
/// plane that fits the 12 nearest samples best, each weighted by its distance; it is kept inside their range, so nothing
/// overshoots. Where the measurement does not reach is a hole.
struct ScatteredBrdf {
    ScatteredMetric metric;                ///< of the two, the one that tells samples better from the others
    std::vector<DirectionPair> directions; ///< as measured
    std::vector<Angles> points;            ///< their places in the metric, ascending in the first number
    std::vector<double> values;            ///< `channels` per point, 1/sr
    std::size_t channels = 1;
    double largestTheta = 0.0; ///< no sample looks, or is lit, from farther off N
    double reach = 0.0;        ///< farther than this from the nearest sample is a hole
    Provenance provenance;
};

[[nodiscard]] Angles scatteredPoint(const ScatteredMetric& metric, const Vec3d& L, const Vec3d& V);

/// `L`, `V` and `values` (channels per sample) as measured; at least one sample.
[[nodiscard]] ScatteredBrdf scatteredBrdf(const std::vector<Vec3d>& L, const std::vector<Vec3d>& V,
                                          const std::vector<double>& values, std::size_t channels);

/// More samples than these are refused by the readers: every look-up visits all of them.
inline constexpr std::size_t mostScattered = 50000;

/// As for a table.
[[nodiscard]] std::optional<Mat3d> brdfAt(const ScatteredBrdf& brdf, const Vec3d& L, const Vec3d& V);

/// What the other samples say at this one's place; nothing where they do not reach it.
[[nodiscard]] std::optional<Channels> leftOut(const ScatteredBrdf& brdf, std::size_t sample);

} // namespace reflectance
