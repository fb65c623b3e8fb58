// RGL's adaptive parameterisation (Dupuy and Jakob 2018), evaluated as it is defined: values stand on a square that is
// warped by the distribution of visible normals, so that they lie dense where the surface shines.
#pragma once

#include "core/measured/bilinear.h"
#include "core/measured/table.h"

namespace reflectance {

/// An isotropic measurement.
struct RglBrdf {
    std::vector<double> thetaI;      ///< radians, ascending: one slice each
    BilinearGrid ndf, sigma;         ///< over (azimuth, polar angle), in the unit square
    std::vector<WarpedSquare> warps; ///< one per slice: the density of visible normals
    std::vector<BilinearGrid> rgb;   ///< three per slice, on the warped square
    bool hasJacobian = true;
    std::size_t channels = 3;
    Provenance provenance;
};

/// As for a table. The stored product f cos(theta_r) is divided by the cosine.
[[nodiscard]] std::optional<Mat3d> brdfAt(const RglBrdf& brdf, const Vec3d& L, const Vec3d& V);

} // namespace reflectance
