// What can be said of a colour matrix K without looking at a picture.
#pragma once

#include <array>
#include <complex>
#include <span>

namespace reflectance::properties {

struct MatrixFacts {
    std::array<double, 3> rowSums{};                   ///< what each sensor sees of white light
    std::array<std::complex<double>, 3> eigenvalues{}; ///< by falling magnitude
    double spectralRadius = 0.0;                       ///< below 1: light between two such surfaces dies out
    int negativeEntries = 0;
    bool passive = false; ///< no negative entry and no row sum above 1
};

/// K holds nine numbers row by row.
[[nodiscard]] MatrixFacts matrixFacts(std::span<const double> K);

} // namespace reflectance::properties
