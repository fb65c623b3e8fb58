// Where properties are looked at: parameter values over the ranges of the sliders, and directions. Deterministic, so that
// every run and every machine looks at the same places.
#pragma once

#include "core/math/vec.h"
#include "core/reflectance/model_text.h"

#include <vector>

namespace reflectance::properties {

/// Flat values of a model: its defaults; the corners, where every parameter is at its low or its high end; each parameter
/// at its landmarks, the others at their high ends; and `interior` points spread evenly in between. Numbers and colours
/// run over their sliders. A matrix is taken as what a passive surface may have: no negative entry, no row sum above 1.
/// A list is its default times -1 to 2.
[[nodiscard]] std::vector<std::vector<double>> parameterSamples(const ModelText& model, std::size_t interior);

/// The defaults with one number at an end of its legal range, where that lies beyond the slider: n = 0, n = 1e7.
[[nodiscard]] std::vector<std::vector<double>> legalEnds(const ModelText& model);

/// Unit vectors.
struct Directions {
    Vec3d N, L, V;
};

/// No cosine of an angle to N is smaller than this in directionSamples: rounding of N.L is then amplified 1000 times
/// at most.
inline constexpr double smallestCosine = 1e-3;

/// Light and viewer above the surface. A third of the viewers stands anywhere, a third about the mirrored light and a
/// third about the light itself, 1e-4 to 1 rad away, so that highlights of any width are met.
[[nodiscard]] std::vector<Directions> directionSamples(std::size_t count);

/// The light on the horizon or below it, the viewer anywhere, also below.
[[nodiscard]] std::vector<Directions> unlitSamples(std::size_t count);

} // namespace reflectance::properties
