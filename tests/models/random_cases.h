// Random rows for every model, with the corners where formulas break drawn on purpose.
#pragma once

#include "tests/models/oracle.h"

#include <vector>

namespace reflectance::test {

/// Directions everywhere, at grazing light, light and viewer both grazing, one of them at N, and at offsets of 1e-8 to
/// 1.6 rad from the highlight's peak; vectors from 1e-200 to 1e200 long; n from 0 to 1e7, half of them integers; entries
/// of K of both signs. The same rows every time.
[[nodiscard]] std::vector<OracleCase> randomCases(const std::string& model, std::size_t count);

/// `usual`, or what REFLECTANCE_ORACLE_ROWS says: the thorough run asks for 100000.
[[nodiscard]] std::size_t rowsPerModel(std::size_t usual);

/// A unit vector that lies `angle` radians from the unit vector v, towards a direction chosen by `azimuth`.
[[nodiscard]] Vec3d tilted(const Vec3d& v, double angle, double azimuth);

} // namespace reflectance::test
