// A measured surface as a value: BRDF numbers on a grid of angles, and how to look between them. Nothing is
// extrapolated: outside the measured range is a hole.
#pragma once

#include "core/base/result.h"
#include "core/measured/angles.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// Between the samples: the nearest one, linear in every angle, or monotone cubic in every angle (no overshoot).
enum class Interpolation { Nearest, Linear, MonotoneCubic };

[[nodiscard]] constexpr std::string_view nameOf(Interpolation interpolation)
{
    constexpr std::string_view names[] = {"nearest", "linear", "cubic"};
    return names[static_cast<int>(interpolation)];
}

/// Where the numbers come from and what was done to them.
struct Provenance {
    std::string name;          ///< of the file or the surface
    std::string format;        ///< "MERL binary"
    std::string convention;    ///< what the file holds and in which units: "BRDF x cos(theta_r); radians"
    std::size_t surfaces = 1;  ///< in the file, of which this is one
    std::size_t samples = 0;   ///< numbers or tuples of numbers in the file
    std::size_t holes = 0;     ///< of them marked as unmeasured, or missing from a grid
    std::size_t negatives = 0; ///< samples with a negative number: kept as they are
    std::vector<std::string> warnings;
};

/// 1 number: grey. 3: the diagonal of K, linear sRGB. 9: K row by row.
using Channels = std::array<double, 9>;

struct Table {
    AngleSystem system = AngleSystem::Polar;
    /// One per angle of the system, in its order: radians, ascending by more than 1e-12, at least one sample each.
    std::vector<std::vector<double>> axes;
    std::size_t channels = 1; ///< 1, 3 or 9
    /// f in 1/sr; the last axis runs fastest, and within a sample the channels. A hole is NaN in all of its channels.
    std::vector<double> values;
    Interpolation interpolation = Interpolation::Linear;
    Provenance provenance;

    [[nodiscard]] std::size_t samples() const { return values.size() / channels; }
    [[nodiscard]] bool isHole(std::size_t sample) const { return std::isnan(values[sample * channels]); }
};

/// Whether the table keeps what its members promise; the sentence says which axis or number does not.
[[nodiscard]] Result<void> checkedTable(const Table& table);

/// The interpolated numbers (the first `channels` of them; the rest is 0) at angles in radians, as anglesOf gives them.
/// Holes take no part: what is left is weighted anew, and where holes had more than half of the weight there is a hole.
/// Angles up to 1e-9 rad outside the grid count as its rim, what rounding of a direction can miss.
[[nodiscard]] std::optional<Channels> valueAt(const Table& table, const Angles& at);

/// f(L, V) as the matrix that a light's colour is multiplied with (grey: a multiple of 1), in 1/sr. L and V are unit
/// vectors about N = (0,0,1); nothing where one of them is not above the surface.
[[nodiscard]] std::optional<Mat3d> brdfAt(const Table& table, const Vec3d& L, const Vec3d& V);

/// Channels as that matrix.
[[nodiscard]] Mat3d matrixOf(const Channels& values, std::size_t channels);

} // namespace reflectance
