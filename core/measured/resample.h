// Any surface brought onto a grid of angles, and how far the grid then is from it.
#pragma once

#include "core/measured/measurement.h"

#include <functional>
#include <span>

namespace reflectance {

/// The angles of a table that is still to be filled.
struct GridShape {
    AngleSystem system = AngleSystem::Isotropic;
    std::vector<std::vector<double>> axes; ///< radians

    [[nodiscard]] std::size_t samples() const;
};

/// theta_i and theta_r in `thetas` even steps from 0 to 90 degrees; for the isotropic grid, delta_phi in `phis` from 0 to 180.
[[nodiscard]] GridShape polarShape(std::size_t thetas);
[[nodiscard]] GridShape isotropicShape(std::size_t thetas, std::size_t phis);
/// theta_h in steps that widen as MERL's, theta_d and phi_d in even ones: for surfaces with a highlight.
[[nodiscard]] GridShape halfDifferenceShape(std::size_t thetaH, std::size_t thetaD, std::size_t phiD);

/// f of many pairs of unit directions about N = (0,0,1), all above the surface; nothing in holes.
using BrdfFunction = std::function<std::vector<std::optional<Mat3d>>(std::span<const DirectionPair>)>;

[[nodiscard]] BrdfFunction functionOf(const Measurement& measurement); ///< refers to it

/// f at every sample of the grid. Directions lower than half a degree above the surface count as that high: at the horizon
/// some models grow without bound. Half and difference angles name pairs below the surface too; those within a step of it
/// are raised in the same way, so that interpolation has something to stand on; the rest are holes. They also cannot tell a
/// pair from its reverse: f is then the mean of both.
[[nodiscard]] Table sampled(const GridShape& shape, std::size_t channels, const BrdfFunction& f);

/// What a table lost against the function that it was made from, in f cos(theta_i): what a picture shows.
struct ResamplingError {
    double rms = 0.0;   ///< root of the mean square difference, over that of the function itself
    double worst = 0.0; ///< largest difference, over the largest value met
    DirectionPair at;   ///< where that is
    std::size_t compared = 0;
    std::size_t lost = 0; ///< pairs of directions at which f is known and the table has a hole
};

/// On 4096 pairs of directions that are the same every time: half of them cosine-distributed, half near the mirror direction;
/// all but those lower than 2 degrees above the surface.
[[nodiscard]] ResamplingError resamplingError(const BrdfFunction& f, const Table& table);

/// A measurement as the renderers take it. A grid of polar, isotropic or half and difference angles is itself. Everything
/// else is sampled, over half and difference angles (91 x 46 x 37) or isotropic ones (46 x 46 x 46), whichever errs less:
/// the first follow highlights, the second keep what is not reciprocal. The provenance says which, and with what error.
[[nodiscard]] Table gridOf(const Measurement& measurement);

/// "0.5 % rms, 3 % at worst".
[[nodiscard]] std::string sentenceOf(const ResamplingError& error);

} // namespace reflectance
