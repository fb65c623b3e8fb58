// Directions with weights: integrals over the hemisphere above a surface become sums.
#pragma once

#include "core/math/vec.h"

#include <vector>

namespace reflectance::properties {

struct GaussLegendre {
    std::vector<double> x, weight; ///< on 0 .. 1
};

/// The rule of this order, exact for polynomials up to degree 2 order - 1.
[[nodiscard]] GaussLegendre gaussLegendre(int order);

/// The hemisphere is that about (0,0,1). Its directions are taken in polar coordinates about an axis that leans `lean`
/// radians towards +x. Circles about the axis are graded by powers of two, down to 1e-4 rad, so that a highlight of any
/// width is met by many of them; they break where the integrand may: where they reach the horizon, a right angle away
/// from the axis, and `rim` radians away (the edge of a light's disc; 0: none).
struct HemisphereGrid {
    double lean = 0.0;
    double rim = 0.0;
};

struct WeightedDirection {
    Vec3d direction;
    double weight = 0.0; ///< steradian
};

/// The weights sum to 2 pi. `order` is the number of circles between two breaks, and half of the points on a circle.
[[nodiscard]] std::vector<WeightedDirection> hemisphere(const HemisphereGrid& grid, int order);

/// For matte surfaces, which bend at other places: polar coordinates about (0,0,1), in circles that break at the polar
/// angle `rim` (radians) and are graded by powers of two towards the horizon, in arcs of a quarter that begin at +x.
/// `order` points on each arc and between two breaks.
[[nodiscard]] std::vector<WeightedDirection> uprightHemisphere(double rim, int order);

} // namespace reflectance::properties
