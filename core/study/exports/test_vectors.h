// What an exported model checks itself by: directions, what double gives for them, and how far other arithmetics may be off.
#pragma once

#include "core/reflectance/catalogue.h"

#include <span>
#include <vector>

namespace reflectance {

/// Unit vectors, a light, and the factor times the light in double, the truth.
struct TestVector {
    Vec3d N, L, V, I;
    double lightRadius = 0.0; ///< degrees; serves a model that sees lights with an extent
    Vec3d expected;
    /// How far each channel moves when an input moves by one unit of roundoff, over that unit, summed over the components
    /// of N, L and V and over all parameters: kappa |expected|, by differences of 16 units of 2^-24 both ways.
    Vec3d sensitivity;
};

/// What an arithmetic with this unit roundoff (2^-53 or 2^-24) may be off by, per channel: 64 (kappa + 1) of two such units
/// of |expected| - GLSL leaves divisions 2.5 units and the order of sums open - and 2^-90 of the light (double: 2^-960),
/// below which a highlight's tail may be flushed to 0 whatever height it is multiplied by.
[[nodiscard]] Vec3d toleranceOf(const TestVector& vector, double roundoff);

/// About two normals: lights from N down to 85 degrees, viewers at and about the mirrored direction (1e-3 to 0.5 rad, so
/// that highlights of any width are met), back at the light, aside, grazing; light and viewer below the horizon. The same
/// every time.
[[nodiscard]] std::vector<TestVector> testVectors(const Model& model, std::span<const double> values,
                                                  const MeasuredSurfaces& measured = {});

/// A grid for tables: light and viewer from 0 to 85 degrees from N = (0,0,1), five azimuths between them, white light.
[[nodiscard]] std::vector<TestVector> gridVectors(const Model& model, std::span<const double> values,
                                                  const MeasuredSurfaces& measured = {});

} // namespace reflectance
