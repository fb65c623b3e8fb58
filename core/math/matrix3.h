// What colour needs of 3x3 matrices.
#pragma once

#include "core/math/vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace reflectance {

[[nodiscard]] constexpr Mat3d transposed(const Mat3d& m)
{
    const auto& r = m.rows;
    return {{{r[0].x, r[1].x, r[2].x}, {r[0].y, r[1].y, r[2].y}, {r[0].z, r[1].z, r[2].z}}};
}

[[nodiscard]] constexpr Mat3d operator*(const Mat3d& a, const Mat3d& b)
{
    const Mat3d columns = transposed(b);
    return {{columns * a.rows[0], columns * a.rows[1], columns * a.rows[2]}};
}

[[nodiscard]] constexpr Mat3d diagonalMatrix(const Vec3d& d)
{
    return {{{d.x, 0.0, 0.0}, {0.0, d.y, 0.0}, {0.0, 0.0, d.z}}};
}

[[nodiscard]] constexpr Vec3d diagonalOf(const Mat3d& m)
{
    return {m.rows[0].x, m.rows[1].y, m.rows[2].z};
}

/// The nine numbers row by row, as files and parameters hold a matrix.
[[nodiscard]] constexpr std::array<double, 9> rowByRow(const Mat3d& m)
{
    const auto& r = m.rows;
    return {r[0].x, r[0].y, r[0].z, r[1].x, r[1].y, r[1].z, r[2].x, r[2].y, r[2].z};
}

/// Singular values, largest first, by one-sided Jacobi rotations: small ones keep their digits.
[[nodiscard]] inline Vec3d singularValues(const Mat3d& m)
{
    Mat3d turned = transposed(m);
    auto& columns = turned.rows;
    constexpr std::pair<int, int> pairs[] = {{0, 1}, {0, 2}, {1, 2}};
    for (int sweep = 0; sweep < 30; ++sweep) { // quadratic convergence: 5 to 8 sweeps are what it takes
        for (const auto& [i, j] : pairs) {
            const double mixed = dot(columns[i], columns[j]);
            if (mixed == 0.0)
                continue;
            const double ratio = 0.5 * (dot(columns[j], columns[j]) - dot(columns[i], columns[i])) / mixed;
            const double t = (ratio < 0.0 ? -1.0 : 1.0) / (std::fabs(ratio) + std::hypot(1.0, ratio));
            const double c = 1.0 / std::hypot(1.0, t);
            const Vec3d old = columns[i];
            columns[i] = c * (old - t * columns[j]);
            columns[j] = c * (columns[j] + t * old);
        }
    }
    std::array<double, 3> values{length(columns[0]), length(columns[1]), length(columns[2])};
    std::sort(values.begin(), values.end());
    return {values[2], values[1], values[0]};
}

/// Largest singular value over smallest: how much relative errors may grow. Infinite for a singular matrix.
[[nodiscard]] inline double conditionNumber(const Mat3d& m)
{
    const Vec3d s = singularValues(m);
    return s.x / s.z;
}

/// By elimination with pivots, so that errors grow with the condition number and no faster. The matrix must not be
/// singular: ask conditionNumber first.
[[nodiscard]] inline Mat3d inverse(const Mat3d& m)
{
    std::array<std::array<double, 6>, 3> rows{};
    for (std::size_t i = 0; i < 3; ++i)
        rows[i] = {m.rows[i].x, m.rows[i].y, m.rows[i].z, i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto larger = [c](const auto& a, const auto& b) { return std::fabs(a[c]) < std::fabs(b[c]); };
        std::swap(rows[c], *std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(c), rows.end(), larger));
        const double pivot = rows[c][c];
        for (double& entry : rows[c])
            entry /= pivot;
        for (std::size_t i = 0; i < 3; ++i) {
            const double factor = i == c ? 0.0 : rows[i][c];
            for (std::size_t k = 0; k < 6; ++k)
                rows[i][k] -= factor * rows[c][k];
        }
    }
    return {{{rows[0][3], rows[0][4], rows[0][5]},
             {rows[1][3], rows[1][4], rows[1][5]},
             {rows[2][3], rows[2][4], rows[2][5]}}};
}

} // namespace reflectance
