// How wide a highlight is: the number of the model that says it, and which of its values puts the highlight's edge at a point.
#pragma once

#include "core/study/probe/probe.h"

#include <optional>

namespace reflectance {

/// Where a highlight ends, of its height.
inline constexpr double edgeHeight = 0.5;

struct SpotWidth {
    const Parameter* parameter = nullptr; ///< of the surface's model: n, alpha, m, ...
    bool widens = false;                  ///< a larger value makes a wider highlight
};

/// The number of the model on which the shape of its highlight depends most, as the formula itself shows: own models, too. None
/// where the surface has no highlight, or nothing but tables and lists to shape it.
[[nodiscard]] std::optional<SpotWidth> spotWidthOf(const Scene& scene);

/// A light's highlight at a point, of what it would be there if the surface faced half way between light and eye: 1 where R.V = 1,
/// (R.V)^n for Phong. 0 where the light is behind the surface. The formula's diffuse term has no part in it. None where there is
/// no highlight.
[[nodiscard]] std::optional<double> spotHeight(const Scene& scene, const Light& light, const ProbedPoint& point);

/// The value with which the highlight at the point is that high; within the slider's range, or up to the present value where
/// that lies outside. What no value gives is met as nearly as the range allows.
[[nodiscard]] double widthWithHeightAt(const Scene& scene, const SpotWidth& width, const Light& light,
                                       const ProbedPoint& point, double height);

} // namespace reflectance
