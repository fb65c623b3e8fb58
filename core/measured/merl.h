// The grid of MERL's files (Matusik et al. 2003): theta_h in steps that widen, theta_d and phi_d in even ones.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace reflectance::merl {

struct Size {
    std::size_t thetaH = 90, thetaD = 90, phiD = 180;

    [[nodiscard]] std::size_t cells() const { return thetaH * thetaD * phiD; }
};

/// f = value * scale, per channel.
inline constexpr double scale[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

/// Sample i of theta_h stands at (i / count)^2 * 90 degrees, the others at even steps. One node more than the file has: a
/// sample of theta_h or theta_d holds for its cell, so the last one holds up to 90 degrees, and phi_d = 180 is phi_d = 0.
[[nodiscard]] std::vector<double> thetaHNodes(std::size_t count);
[[nodiscard]] std::vector<double> evenNodes(std::size_t count, double end);

} // namespace reflectance::merl
